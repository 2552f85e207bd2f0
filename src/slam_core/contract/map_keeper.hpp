// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/map_kind.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// The capability of a back-end whose map and pose can be saved and loaded.
class MapKeeper {
 public:
  virtual ~MapKeeper() = default;
  virtual MapState state() const = 0;  ///< all that save_map writes
  /// The next execute() replaces the map and the pose. If there is no joint covariance, the
  /// marginals are inflated. If the map cannot be used, that step returns an error and leaves map
  /// and pose as they are.
  virtual void set(const MapState& map) = 0;
};

/// The capability of a back-end that offers several representations of the map.
class MapChooser {
 public:
  virtual ~MapChooser() = default;
  virtual std::vector<MapKind> maps() const = 0;
  /// Chooses one of maps() from the next configure() on. The ports are those of this map at once.
  virtual void useMap(MapKind map) = 0;
};

}  // namespace slam
