// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::grid_map {

/// A scan goes into the map: cells on the way of a beam become less likely occupied, that in which
/// it ends more likely. A cell in which a beam ends is not on the way of another beam of the scan.
/// @param pose T_map_base
/// @return beams that end beyond the largest map
std::size_t insertScan(const BeamModel& model, const ScanPoints& scan, const Pose2& pose,
                       GridMap& map);

}  // namespace slam::grid_map
