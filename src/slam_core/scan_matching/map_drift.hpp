// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>

#include "slam_core/models/landmark_map.hpp"

namespace slam::scan_matching {

/// The uncertainty of the parts of a map that is drawn scan by scan and closes no loops. A part is
/// off by the error of the robot that drew it. Back at a part, the robot's covariance is that of
/// the part again; beyond, it grows with each metre. The errors of successive metres are taken for
/// independent, so that their variances add (a random walk).
class MapDrift {
 public:
  /// @param position, heading standard deviation after a metre [m, rad]
  MapDrift(double position, double heading)
      : variance_per_metre_(position * position, position * position, heading * heading) {}

  /// The map starts there, or starts over: what is drawn from now on has at least this covariance,
  /// also where older parts are around.
  void restart(const PoseEstimate& first);
  /// A scan from there, which fits the parts around it, has gone into the map.
  void add(const Pose2& pose);
  /// The covariance, in (x, y, theta), of a robot that knows exactly where it is relative to the
  /// parts around it.
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;
  /// Whether the robot knows less of its place among the parts of the map around it than is known
  /// of theirs, and so little that what it draws may be out of place.
  bool isSurerThan(const PoseEstimate& robot) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(oldest_, last_);
  }

 private:
  /// The oldest place in the 3x3 squares around the pose, else the last one. Older parts have the
  /// smaller covariance.
  const PoseEstimate& oldestNearby(const Pose2& pose) const;

  Eigen::Vector3d variance_per_metre_;
  struct Place {
    std::size_t age_rank;  ///< the oldest: 0
    PoseEstimate pose;

    template <class Archive>
    void persist(Archive& archive) {
      archive(age_rank, pose);
    }
  };
  std::unordered_map<std::uint64_t, Place> oldest_;  ///< of each square of the plane
  PoseEstimate last_;
};

}  // namespace slam::scan_matching
