// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/particle_filter/landmarks/proposal.hpp"

namespace slam::particle_filter {

/// What a step does to a particle's weight: a factor before the pose is drawn, on which resampling
/// rests, and one after (the auxiliary particle filter of Pitt, Shephard 1999). Both logarithms;
/// for several threads at once.
class Weighting {
 public:
  virtual ~Weighting() = default;

  /// @param predictions so many, of all observations
  virtual double logFactor(const Prediction* predictions, std::size_t count) const;

  /// @param map before the step's observations went into it
  /// @param predictions those that logFactor() had
  virtual double logCorrection(const ObservationModel& model, const Sight& sight,
                               const ParticleMap& map, const PoseGaussian& prior,
                               const PoseGaussian& proposal, const Pose2& drawn,
                               const Prediction* predictions) const = 0;
};

/// How well the particle predicted the observations, motion noise included where the proposal
/// looked at them (Montemerlo 2003, ch. 4). It does not depend on the draw, which leaves the least
/// variance to the weights.
class PredictiveWeighting final : public Weighting {
 public:
  double logCorrection(const ObservationModel&, const Sight&, const ParticleMap&,
                       const PoseGaussian&, const PoseGaussian&, const Pose2&,
                       const Prediction*) const override {
    return 0.0;
  }
};

/// Target over proposal at the pose drawn, exact where the observation model bends, too: the
/// correction is what that makes different from the predictive weight.
class ImportanceWeighting final : public Weighting {
 public:
  double logCorrection(const ObservationModel& model, const Sight& sight, const ParticleMap& map,
                       const PoseGaussian& prior, const PoseGaussian& proposal, const Pose2& drawn,
                       const Prediction* predictions) const override;
};

const std::vector<std::string>& weightingNames();
/// `name` is one of weightingNames().
std::unique_ptr<Weighting> makeWeighting(const std::string& name);

}  // namespace slam::particle_filter
