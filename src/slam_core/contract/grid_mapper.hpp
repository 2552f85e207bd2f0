// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>

#include "slam_core/models/occupancy_grid.hpp"

namespace slam {

/// The capability of a back-end that makes an occupancy grid.
class GridMapper {
 public:
  virtual ~GridMapper() = default;
  /// The grid, cropped to the part that has been seen; nothing before the first scan.
  virtual std::optional<OccupancyGrid> grid() const = 0;
  /// Increases whenever grid() has changed, also when the map starts over.
  virtual std::uint64_t gridRevision() const = 0;
};

}  // namespace slam
