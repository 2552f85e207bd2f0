// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/grid_map/tile_set.hpp"

namespace slam::grid_map {

/// A scan goes into the map: cells on the way of a beam become less likely occupied, that in which
/// it ends more likely. A cell in which a beam ends is not on the way of another beam of the scan.
/// @param pose T_map_base
/// @return beams that end beyond the largest map
std::size_t insertScan(const BeamModel& model, const ScanPoints& scan, const Pose2& pose,
                       GridMap& map);

/// The same for a map that is shown and never matched with: it gets no likelihoods.
/// @param among only these tiles are written, by a scan of which no beam's reading depends on the
/// map (dependsOnMap()); null: all
void drawScan(const BeamModel& model, const ScanPoints& scan, const Pose2& pose,
              const TileSet* among, GridMap& map);

/// Adds all tiles that the scan writes to, by column and row. How its beams are read must not
/// depend on the map (dependsOnMap()).
void addTilesOf(const ScanPoints& scan, const Pose2& pose, std::vector<CellIndex>& tiles);

}  // namespace slam::grid_map
