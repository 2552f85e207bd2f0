// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/grid_map/scan_matcher.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"

namespace slam::particle_filter {

/// What a particle makes of a scan.
struct ScanDraft {
  PoseGaussian pose;  ///< to draw from; without covariance where it has been drawn already
  /// Logarithm of the likelihood of the scan, knowing the particle's pose before the motion.
  double log_evidence = 0.0;
};

/// The density from which the new pose of a particle is drawn when a scan has come: what Proposal
/// is for landmarks.
class ScanProposal {
 public:
  virtual ~ScanProposal() = default;

  /// For several threads at once.
  /// @param prior where motion alone puts this particle
  virtual ScanDraft propose(const grid_map::ScanLikelihood& likelihood,
                            const grid_map::ScanPoints& scan, const grid_map::GridMap& map,
                            const PoseGaussian& prior, RandomStream& random) const = 0;
};

/// The motion prior; the scan weighs the pose drawn (thesis 5.7; Thrun, Burgard, Fox 2005, ch. 13).
class MotionScanProposal final : public ScanProposal {
 public:
  ScanDraft propose(const grid_map::ScanLikelihood& likelihood, const grid_map::ScanPoints& scan,
                    const grid_map::GridMap& map, const PoseGaussian& prior,
                    RandomStream& random) const override;
};

/// A Gaussian about the place where scan and motion fit the map best, from samples around it; their
/// sum is the integral of likelihood and motion (Grisetti, Stachniss, Burgard 2007, alg. 1). The
/// samples stand on a lattice as wide as the peak: so few drawn at random would be noise in the
/// weights. Where there is nothing to match it is the motion prior.
class MatchedScanProposal final : public ScanProposal {
 public:
  explicit MatchedScanProposal(std::unique_ptr<grid_map::ScanMatcher> matcher)
      : matcher_(std::move(matcher)) {}

  ScanDraft propose(const grid_map::ScanLikelihood& likelihood, const grid_map::ScanPoints& scan,
                    const grid_map::GridMap& map, const PoseGaussian& prior,
                    RandomStream& random) const override;

 private:
  std::unique_ptr<grid_map::ScanMatcher> matcher_;
};

}  // namespace slam::particle_filter
