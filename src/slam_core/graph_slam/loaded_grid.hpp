// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/scan_matching/drawn_grid.hpp"

namespace slam::graph_slam {

using scan_matching::drawn;

/// Places in a grid, metres apart, where a robot could have been.
std::vector<Pose2> placesIn(const OccupancyGrid& grid);

}  // namespace slam::graph_slam
