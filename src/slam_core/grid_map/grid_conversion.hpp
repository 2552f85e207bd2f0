// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/status.hpp"
#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::grid_map {

/// All that is known of a map, cut to what has been seen; without cells where that is nothing.
OccupancyGrid occupancyGridOf(const GridMap& map, double resolution);

/// The map that a grid shows, which may have another resolution and lie between our cells: a cell
/// of ours is as likely occupied as the most likely one that it touches. Beams are taken to have
/// ended in the middle of what is occupied.
/// @param model of the map's cells
/// @return a warning where the map has no room for all of it, an error where the grid is none; the
/// map then stays empty
Status fillFrom(const OccupancyGrid& grid, const BeamModel& model, GridMap& map);

/// Sum over all cells that have been seen of the entropy of being occupied or not [bit].
double entropyOf(const GridMap& map);

}  // namespace slam::grid_map
