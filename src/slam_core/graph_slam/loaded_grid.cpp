// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/loaded_grid.hpp"

#include <algorithm>
#include <cstdint>

namespace slam::graph_slam {

std::vector<Pose2> placesIn(const OccupancyGrid& grid) {
  constexpr double kApart = 2.0;  // [m]
  constexpr std::int8_t kFree = 50;
  std::vector<Pose2> places;
  const auto stride = static_cast<std::uint32_t>(std::max(1.0, kApart / grid.resolution));
  for (std::uint32_t y = 0; y < grid.height; y += stride)
    for (std::uint32_t x = 0; x < grid.width; x += stride) {
      const auto cell = grid.cells[std::size_t{y} * grid.width + x];
      if (cell < 0 || cell >= kFree) continue;
      places.emplace_back(grid.origin.x() + x * grid.resolution,
                          grid.origin.y() + y * grid.resolution, 0.0);
    }
  return places;
}

}  // namespace slam::graph_slam
