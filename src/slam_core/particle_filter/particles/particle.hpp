// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/particle_filter/memory/shared_path.hpp"
#include "slam_core/particle_filter/particles/particle_map.hpp"

namespace slam::particle_filter {

/// One hypothesis of where the robot has been, and the map that follows from it (Eq. 5.5). Copying
/// one copies pointers.
struct Particle {
  Pose2 pose;  ///< T_map_base
  ParticleMap map;
  grid_map::GridMap grid;  ///< empty where the filter makes none
  SharedPath path;
  grid_map::GridMap coarse_grid;  ///< the same in larger cells
  /// Where motion alone has led it since the last scan: what landmarks have moved it by since then
  /// lies between this and its pose.
  Pose2 followed;

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose, map, grid, path, coarse_grid, followed);
  }
};

}  // namespace slam::particle_filter
