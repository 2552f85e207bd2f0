// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/active_path/ways.hpp"

namespace slam::active_path {

/// A piece of the border between what is known to be free and what is not known (Yamauchi 1997).
struct Frontier {
  std::vector<Cell> cells;  ///< free ones beside the unknown, next to one another
  Cell middle = 0;          ///< the one nearest to their mean
  Cell viewpoint = 0;       ///< where the robot comes near to `middle`, a radius before it
};

/// The frontiers that the robot can come near to: free cells lead from a reached cell to them
/// within three radii. What lies behind a wall, or far behind a door too narrow for the robot, is
/// none. Long frontiers are cut into pieces of about a metre. The viewpoint of each is on the way
/// to the reached cell that is the nearest through free cells, so far back that the robot does not
/// stand in the unknown.
/// @param min_length shorter pieces are left out [m]
std::vector<Frontier> frontiersOf(const FreeSpace& space, const Ways& ways, double robot_radius,
                                  double min_length);

}  // namespace slam::active_path
