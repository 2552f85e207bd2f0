// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"

namespace slam::grid_map {

CellIndex cellOf(const Eigen::Vector2d& point);

/// What a beam says of the cells along it.
struct BeamReading {
  Eigen::Vector2d end;  ///< as measured [cells]
  CellIndex hit;        ///< of the surface that it met
  CellIndex free_to;    ///< the cells up to here, without this one, are free
};

/// Where the range is so noisy that the end may lie in another cell than what the beam met, that is
/// the most likely one of the occupied cells within the noise, and of the end's own, which may be
/// new: by how far the end is off, how sure the map is of the cell, and of those that would have
/// stopped the beam before (a forward model of the beam; Thrun 2003). Taken as they fall, ends
/// beyond a wall would stay there, as no beam passes to free them, while those before it vanish:
/// walls would move away from the robot.
/// @param origin the sensor [cells]
/// @param sigma of the range [cells]
BeamReading readingOf(const Eigen::Vector2d& origin, const Eigen::Vector2d& end, double sigma,
                      const GridMap& map);

/// Whether what the map holds may matter for how a beam is read. @param sigma of the range [cells]
bool dependsOnMap(double sigma);

}  // namespace slam::grid_map
