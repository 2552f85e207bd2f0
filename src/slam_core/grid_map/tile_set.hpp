// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam_core/grid_map/grid_map.hpp"

namespace slam::grid_map {

/// The rectangle of all these tiles, in tiles.
CellRectangle rectangleOf(const std::vector<CellIndex>& tiles);

/// Leaves each tile once, in the order of their rows.
void keepDistinct(std::vector<CellIndex>& tiles);

/// Some tiles of a map, which are numbered as cells are: tile (0, 0) has its lower left corner in
/// the map's origin. The memory is that of their rectangle, 4 bytes a tile.
class TileSet {
 public:
  /// @param tiles in any order; one may be there more than once
  explicit TileSet(std::vector<CellIndex> tiles);

  /// In the order of their rows.
  const std::vector<CellIndex>& tiles() const { return tiles_; }
  /// Whether one of them lies in the rectangle that has these two tiles in opposite corners.
  bool touches(CellIndex a, CellIndex b) const;
  bool contains(CellIndex tile) const { return touches(tile, tile); }

 private:
  std::size_t at(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * (static_cast<std::size_t>(rectangle_.width) + 1) +
           static_cast<std::size_t>(x);
  }

  std::vector<CellIndex> tiles_;
  CellRectangle rectangle_;
  std::vector<std::int32_t> sums_;  ///< tiles to the left of each corner and below it (Crow 1984)
};

}  // namespace slam::grid_map
