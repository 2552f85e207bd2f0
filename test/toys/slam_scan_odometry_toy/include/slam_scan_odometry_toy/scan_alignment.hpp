// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/models/laser_scan.hpp"

namespace slam_toy {

/// The points that a scan's beams met, in the robot's frame and in the order of the beams [m]; at
/// most kMostPoints, evenly thinned.
using Points = std::vector<Eigen::Vector2d>;
constexpr std::size_t kMostPoints = 360;
Points pointsOf(const slam::LaserScan& scan);

struct Alignment {
  slam::Pose2 pose;                                      ///< T_reference_points
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of its (x, y, theta)
};

/// The pose from which points fit a reference best: Gauss-Newton on the distances to the line
/// through the nearest reference point's neighbours (Censi, "An ICP variant using a point-to-line
/// metric", ICRA 2008).
/// @return nothing where too few points fit, or they leave a direction open, as in a long corridor
std::optional<Alignment> align(const Points& reference, const Points& points,
                               const slam::Pose2& guess);

/// What is assumed of a robot whose scan tells nothing: it goes on at its velocity.
/// @param twist (m/s, m/s, rad/s) @param dt [s]
Alignment coasted(const Eigen::Vector3d& twist, double dt);

}  // namespace slam_toy
