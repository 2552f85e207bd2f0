// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/models/laser_scan.hpp"

namespace slam::test {

/// A rectangular room around the origin.
struct EmptyRoom {
  double length, width;  ///< along x and y [m]

  /// @return what a laser sees that looks all around @param robot its pose in the room
  LaserScan scanFrom(const Pose2& robot, Stamp stamp = {}) const {
    constexpr int kBeams = 180;
    LaserScan scan;
    scan.stamp = stamp;
    for (int i = 0; i < kBeams; ++i) {
      const double bearing = -M_PI + 2.0 * M_PI * i / kBeams;
      const double c = std::cos(robot.theta() + bearing), s = std::sin(robot.theta() + bearing);
      const double to_x = (std::copysign(0.5 * length, c) - robot.x()) / c;
      const double to_y = (std::copysign(0.5 * width, s) - robot.y()) / s;
      LaserBeam beam;
      beam.bearing = static_cast<float>(bearing);
      beam.range = static_cast<float>(std::min(std::abs(to_x), std::abs(to_y)));
      beam.hit = true;
      scan.beams.push_back(beam);
    }
    return scan;
  }
};

}  // namespace slam::test
