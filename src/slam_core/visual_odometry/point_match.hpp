// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::visual_odometry {

/// One point of the ceiling as it was found in a reference image and in the present one.
struct PointMatch {
  Eigen::Vector2d pixel_reference = Eigen::Vector2d::Zero();  ///< [px]
  Eigen::Vector2d pixel_now = Eigen::Vector2d::Zero();        ///< [px]
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();        ///< on the ceiling, in base then [m]
  Eigen::Vector2d now = Eigen::Vector2d::Zero();              ///< on the ceiling, in base now [m]
  double sigma = 1.0;  ///< of reference - T now in each direction, up to a common factor [m]
};
using PointMatches = std::vector<PointMatch>;

/// Where a match is to be looked for: points of the ceiling may be off from where `T_reference_now`
/// takes them by `distance` [m] and by `angle` [rad] about the robot.
struct SearchWindow {
  Pose2 T_reference_now;
  double distance = 0.0, angle = 0.0;

  double radius(const Eigen::Vector2d& point) const { return distance + angle * point.norm(); }
};

}  // namespace slam::visual_odometry
