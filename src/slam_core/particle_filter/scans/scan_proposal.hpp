// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/random.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"
#include "slam_core/scan_matching/scan_evidence.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::particle_filter {

/// A scan and the map of a particle.
struct ScanInMap {
  const scan_matching::ScanLevels& scan;
  scan_matching::MapView map;
  const scan_matching::ScanEvidence& evidence;

  double log(const Pose2& pose) const { return evidence.log(map.finest().map, scan.front(), pose); }
};

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

  /// To be called once a scan, for the most likely particle.
  /// @param prior where motion alone puts it
  /// @param drift covariance of the surfaces around it relative to the oldest ones, which it may
  /// meet again; nothing if the map is fixed
  /// @return where else the others should look, seen from where motion puts them
  virtual std::optional<Pose2> search(
      [[maybe_unused]] const ScanInMap& scan, [[maybe_unused]] const PoseGaussian& prior,
      [[maybe_unused]] const std::optional<Eigen::Matrix3d>& drift) const {
    return std::nullopt;
  }
  /// For several threads at once.
  /// @param prior where motion alone puts this particle
  /// @param elsewhere of search()
  virtual ScanDraft propose(const ScanInMap& scan, const PoseGaussian& prior,
                            const std::optional<Pose2>& elsewhere, RandomStream& random) const = 0;
};

/// The motion prior; the scan weighs the pose drawn (thesis 5.7; Thrun, Burgard, Fox 2005, ch. 13).
class MotionScanProposal final : public ScanProposal {
 public:
  ScanDraft propose(const ScanInMap& scan, const PoseGaussian& prior,
                    const std::optional<Pose2>& elsewhere, RandomStream& random) const override;
};

/// The Gaussian that a match of the scan with the particle's map and the motion leave of the pose;
/// the evidence is its integral (Laplace's approximation; Grisetti, Stachniss, Burgard 2007, Eq.
/// 12). Where there is nothing to match it is the motion prior.
class MatchedScanProposal final : public ScanProposal {
 public:
  explicit MatchedScanProposal(const scan_matching::MatcherConfig& matcher) : matcher_(matcher) {}

  std::optional<Pose2> search(const ScanInMap& scan, const PoseGaussian& prior,
                              const std::optional<Eigen::Matrix3d>& drift) const override;
  ScanDraft propose(const ScanInMap& scan, const PoseGaussian& prior,
                    const std::optional<Pose2>& elsewhere, RandomStream& random) const override;

 private:
  scan_matching::ScanToMapMatcher matcher_;
};

}  // namespace slam::particle_filter
