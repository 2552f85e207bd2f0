// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/product/landmark_file.hpp"

namespace slam {

/// Where a map is kept.
struct MapFiles {
  std::string landmarks;
  std::string grid;  ///< its yaml, with the image beside it; empty without a grid
};

/// The files that a path stands for: in a folder `landmarks.yaml` and `map.yaml`. Without a grid a
/// file is that of the landmarks. With one it is the grid's: `NAME.yaml` has `NAME.landmarks.yaml`
/// beside it, so that maps in one folder stay apart, and `map.yaml` the folder's `landmarks.yaml`.
/// The path of the landmarks' file stands for the same two files.
MapFiles mapFilesAt(const std::string& path, bool has_grid);

/// Writes the landmarks and, of a map that has one, the grid, as soon as something is known of it.
/// @return what was written and where, for people; of a grid that is missing, that it is
/// @throw std::runtime_error naming the file and the cause; also before landmarks would be written
/// beside the grid of an earlier map
std::string saveMap(const std::string& path, const LandmarkFile& file);

/// Reads a landmarks' file alone, a grid with the landmarks beside it, or of a folder what there is
/// of them. A grid that comes without landmarks' file tells no pose: the robot is taken to be at
/// the origin, give or take 0.5 m and 15 degrees.
/// @param has_grid whether the back-end makes grids; one that does not takes landmarks only
/// @throw std::runtime_error in one sentence, as loadLandmarks() and grid_map::loadGrid()
LandmarkFile loadMap(const std::string& path, const std::string& frame, bool has_grid);

}  // namespace slam
