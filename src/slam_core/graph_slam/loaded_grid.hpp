// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "slam_core/common/status.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::graph_slam {

/// A grid as a map to match scans with.
struct DrawnGrid {
  std::unique_ptr<scan_matching::ScanMap> map;
  Status status;  ///< a warning where not all of the grid is used, an error where none of it is
};
DrawnGrid drawn(const OccupancyGrid& grid, const grid_map::GridMapConfig& config);

/// Places in a grid, metres apart, where a robot could have been.
std::vector<Pose2> placesIn(const OccupancyGrid& grid);

}  // namespace slam::graph_slam
