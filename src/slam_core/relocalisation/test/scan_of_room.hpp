// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/models/test/simulated_room.hpp"

namespace slam::test {

/// A laser in the middle of a robot, whose beams are two degrees apart.
struct CoarseLaser {
  double first = -M_PI;  ///< bearing of the first beam [rad]
  int beams = 180;
  double farthest = 30.0;  ///< that it can measure [m]

  /// @param robot its pose in the room
  LaserScan scanOf(const Room& room, const Pose2& robot, Stamp stamp = {}) const {
    LaserScan scan;
    scan.stamp = stamp;
    scan.sensor_frame = "laser";
    for (int i = 0; i < beams; ++i) {
      const double bearing = first + M_PI / 90.0 * i;
      const double range = room.range(robot.position(), robot.theta() + bearing);
      scan.beams.push_back({static_cast<float>(bearing),
                            static_cast<float>(std::min(range, farthest)), range < farthest});
    }
    return scan;
  }
};

}  // namespace slam::test
