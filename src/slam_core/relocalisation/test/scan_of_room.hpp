// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/models/laser_scan.hpp"

namespace slam::test {

/// A rectangular room around the origin, seen by a laser in the middle of a robot.
struct EmptyRoom {
  double length, width;  ///< along x and y [m]

  /// @return the range from a place in the room to its wall [m]
  double range(const Eigen::Vector2d& from, double direction) const {
    const double c = std::cos(direction), s = std::sin(direction);
    const double to_x = (std::copysign(0.5 * length, c) - from.x()) / c;
    const double to_y = (std::copysign(0.5 * width, s) - from.y()) / s;
    return std::min(std::abs(to_x), std::abs(to_y));
  }

  /// @param robot its pose in the room @param first bearing of the first of the beams, which are
  /// two degrees apart [rad] @param farthest that the laser can measure [m]
  LaserScan scanFrom(const Pose2& robot, Stamp stamp = {}, double first = -M_PI, int beams = 180,
                     double farthest = 30.0) const {
    LaserScan scan;
    scan.stamp = stamp;
    scan.sensor_frame = "laser";
    for (int i = 0; i < beams; ++i) {
      const double bearing = first + M_PI / 90.0 * i;
      const double to_wall = range(robot.position(), robot.theta() + bearing);
      scan.beams.push_back({static_cast<float>(bearing),
                            static_cast<float>(std::min(to_wall, farthest)), to_wall < farthest});
    }
    return scan;
  }
};

}  // namespace slam::test
