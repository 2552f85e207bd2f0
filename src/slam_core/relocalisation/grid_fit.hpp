// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::relocalisation {

/// @param robot T_map_base
/// @return the share of the beams' ends that lie within 0.2 m of an occupied cell; 0
/// if no beam has met anything
double shareOnSurfaces(const OccupancyGrid& grid, const LaserScan& scan, const Pose2& robot);

/// @return the largest share at a pose no further away than 0.4 m along either axis and 0.4 rad, as
/// after a push or a slip
double bestShareOnSurfaces(const OccupancyGrid& grid, const LaserScan& scan, const Pose2& robot);

}  // namespace slam::relocalisation
