// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/map_kind.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// The capability of a back-end whose map and pose can be saved, and taken up again.
class MapKeeper {
 public:
  virtual ~MapKeeper() = default;
  virtual MapState state() const = 0;  ///< all that save_map writes
  /// The map and the pose are replaced with the next execute(). Without a joint covariance the
  /// marginals are inflated. A map that cannot be used is an error of that step, which leaves map
  /// and pose as they are.
  virtual void set(const MapState& map) = 0;
};

/// The capability of a back-end that has several representations of a map to choose from.
class MapChooser {
 public:
  virtual ~MapChooser() = default;
  virtual std::vector<MapKind> maps() const = 0;
  /// Makes this one of maps() from the next configure() on; its ports are those of this map at
  /// once.
  virtual void useMap(MapKind map) = 0;
};

}  // namespace slam
