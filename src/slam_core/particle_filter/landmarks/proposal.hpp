// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/observation_model.hpp"
#include "slam_core/particle_filter/landmarks/sight.hpp"
#include "slam_core/particle_filter/particles/particle_map.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"

namespace slam::particle_filter {

/// How well a particle predicted one observation, knowing those before it in the array.
struct Prediction {
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();
  Eigen::Matrix2d S = Eigen::Matrix2d::Identity();
  double log_likelihood = 0.0;
  /// By how much S would have to be larger for the observation to lie on the edge of the gate; 1
  /// where it lies within.
  double excess = 1.0;
  bool matched = true;       ///< the particle takes it for a landmark of its map
  bool gated = false;        ///< outside the gate: the landmark is not updated by it
  bool established = false;  ///< the landmark has been seen often enough where it should be
};

/// What a particle's predictions say of the particle: whether most of the established landmarks
/// that it sees are not where its map has them.
bool isDoubtful(const Prediction* predictions, std::size_t count);

/// The density from which the new pose of a particle is drawn, and with it what the particle's
/// weight rests on: how well it predicted the observations.
class Proposal {
 public:
  virtual ~Proposal() = default;

  /// Several threads may call it at once.
  /// @param prior where motion alone puts this particle
  /// @param predictions of all observations; those of the matches are written
  /// @return what the pose is to be drawn from; without covariance where it has been drawn already
  virtual PoseGaussian propose(const ObservationModel& model, const Sight& sight,
                               const ParticleMap& map, const PoseGaussian& prior,
                               RandomStream& random, Prediction* predictions) const = 0;
};

/// FastSLAM 1.0 (Montemerlo et al. 2002): the motion prior; observations weigh the pose drawn.
class MotionProposal final : public Proposal {
 public:
  PoseGaussian propose(const ObservationModel& model, const Sight& sight, const ParticleMap& map,
                       const PoseGaussian& prior, RandomStream& random,
                       Prediction* predictions) const override;
};

/// FastSLAM 2.0 (Montemerlo et al. 2003): the motion prior conditioned on the latest observations,
/// refined by one after the other as by an EKF over the pose alone. The predictions include the
/// noise of the motion and do not depend on the pose drawn. A prior with a wide heading is refined
/// again about what comes out, as by an iterated EKF.
class ConditionedProposal final : public Proposal {
 public:
  PoseGaussian propose(const ObservationModel& model, const Sight& sight, const ParticleMap& map,
                       const PoseGaussian& prior, RandomStream& random,
                       Prediction* predictions) const override;
};

/// N(nu; 0, S), outside the gate with a tail that falls like a power instead: an outlier counts
/// against a particle, but only so much, and of two particles that it does not fit the nearer one
/// still counts for more.
Prediction predictionOf(const Eigen::Vector2d& nu, const Eigen::Matrix2d& S, double gate);

/// The prediction of an observation that a particle takes for no landmark of its map: as unlikely
/// as on the edge of the gate, so that a particle neither gains nor loses much where others know
/// the landmark.
Prediction unmatchedPrediction(const LandmarkObservation& z, double gate);

/// The prediction of a landmark that the particle stands on: as unlikely as on the edge of the
/// gate.
Prediction singularPrediction(const LandmarkObservation& z, double gate);

const std::vector<std::string>& proposalNames();
/// `name` is one of proposalNames().
std::unique_ptr<Proposal> makeProposal(const std::string& name);

}  // namespace slam::particle_filter
