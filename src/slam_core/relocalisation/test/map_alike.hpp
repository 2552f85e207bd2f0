// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::test {

/// A map in which only the surfaces that a scan shows stand; where others are it is free.
inline OccupancyGrid mapAlike(OccupancyGrid grid, const LaserScan& scan, const Pose2& base) {
  constexpr double kNear = 0.3;  // [m]
  constexpr std::int8_t kFree = 0, kRatherOccupied = 50;
  const Pose2 laser = base * scan.sensor_pose;
  const auto is_seen = [&](const Eigen::Vector2d& point) {
    return std::any_of(scan.beams.begin(), scan.beams.end(), [&](const auto& beam) {
      const Eigen::Vector2d end(beam.range * std::cos(beam.bearing),
                                beam.range * std::sin(beam.bearing));
      return (laser.transform(end) - point).norm() < kNear;
    });
  };
  for (std::uint32_t y = 0; y < grid.height; ++y)
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      auto& cell = grid.cells[y * grid.width + x];
      const Eigen::Vector2d middle =
          grid.origin + grid.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (cell > kRatherOccupied && !is_seen(middle)) cell = kFree;
    }
  return grid;
}

}  // namespace slam::test
