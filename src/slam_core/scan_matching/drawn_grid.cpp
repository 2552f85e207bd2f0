// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/drawn_grid.hpp"

#include "slam_core/grid_map/grid_conversion.hpp"

namespace slam::scan_matching {

DrawnGrid drawn(const OccupancyGrid& grid, const grid_map::GridMapConfig& config) {
  DrawnGrid result{std::make_unique<ScanMap>(config), {}};
  for (std::size_t i = 0; i < kLevels; ++i) {
    auto& [model, map] = result.map->level(i);
    result.status = moreUrgent(fillFrom(grid, model, map), result.status);
  }
  return result;
}

}  // namespace slam::scan_matching
