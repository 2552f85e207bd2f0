// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>

#include "slam_core/models/landmark_map.hpp"

namespace slam::scan_matching {

/// How sure a map is of where its parts are that was drawn scan by scan and closes no loops. A part
/// errs by what the robot erred when it drew it. Back there, the robot is as sure again; beyond, it
/// is less sure with each metre.
class MapDrift {
 public:
  /// @param position, heading standard deviation after a metre [m, rad]
  MapDrift(double position, double heading)
      : variance_per_metre_(position * position, position * position, heading * heading) {}

  /// The map begins there, or begins anew: what is drawn from now on is as sure as this and no
  /// surer, also where older parts are around.
  void restart(const PoseEstimate& first);
  /// A scan from there, which fits the parts around it, has gone into the map.
  void add(const Pose2& pose);
  /// Of a robot that knows exactly where it is among the parts around it, in (x, y, theta).
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(oldest_, last_);
  }

 private:
  /// Oldest first where they lie in one square: it was drawn by the surest robot.
  const PoseEstimate& nearest(const Pose2& pose) const;

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
