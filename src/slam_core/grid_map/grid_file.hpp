// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "slam_core/models/occupancy_grid.hpp"

namespace slam::grid_map {

/// The image that saveGrid() writes beside `yaml_path`.
/// @throw std::runtime_error where both would have the same name
std::filesystem::path imagePathOf(const std::string& yaml_path);

/// Writes `yaml_path` and beside it the image of the same name with the ending .pgm, as
/// map_server's map_saver does: cells up to 25 % are free (254), those from 65 % on occupied (0),
/// the rest unknown (205). Each file is written whole or not at all, the image first.
/// @throw std::runtime_error naming the file and the cause; of a grid without cells, too,
/// and as imagePathOf()
void saveGrid(const std::string& yaml_path, const OccupancyGrid& grid);

/// Reads what map_server reads: image, resolution, origin, negate, occupied_thresh, free_thresh and
/// mode (trinary, scale, raw), the image a binary PGM.
/// @throw std::runtime_error in one sentence: a file that is missing, cut off or no PGM, a field
/// that is missing or no number, a resolution that is not positive, an origin that is rotated, a
/// size that no map has
OccupancyGrid loadGrid(const std::string& yaml_path);

}  // namespace slam::grid_map
