// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/common/status.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::scan_matching {

/// A grid as a map to match scans with.
struct DrawnGrid {
  std::unique_ptr<ScanMap> map;
  Status status;  ///< a warning if not all of the grid is used, an error if none of it is
};
DrawnGrid drawn(const OccupancyGrid& grid, const grid_map::GridMapConfig& config);

}  // namespace slam::scan_matching
