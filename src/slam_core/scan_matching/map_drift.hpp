// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>

#include "slam_core/models/landmark_map.hpp"

namespace slam::scan_matching {

/// The uncertainty of the parts of a map that is built scan by scan without closing loops. A part
/// has the error that the robot's pose had when it was drawn. When the robot returns to a part, its
/// covariance is that of the part again; beyond, it grows with each metre. The errors of successive
/// metres are taken to be independent, so that their variances add (a random walk).
class MapDrift {
 public:
  /// @param position, heading standard deviation after a metre [m, rad]
  MapDrift(double position, double heading)
      : variance_per_metre_(position * position, position * position, heading * heading) {}

  /// The map starts at this pose, or starts over: all that is drawn from now on has at least this
  /// covariance, even near older parts.
  void restart(const PoseEstimate& first);
  /// A scan that was taken at this pose, and that fits the parts around it, was added to the map.
  void add(const Pose2& pose);
  /// The covariance, in (x, y, theta), of a robot that knows exactly where it is relative to the
  /// parts around it.
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;
  /// Whether the robot's pose relative to the parts of the map around it is less certain than these
  /// parts, and so uncertain that what it draws may be misplaced.
  bool isSurerThan(const PoseEstimate& robot) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(oldest_, last_);
  }

 private:
  /// The oldest place in the 3x3 squares around the pose, or the last place if there is none. Older
  /// parts have smaller covariances.
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
