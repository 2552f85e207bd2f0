// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam_core/grid_map/grid_map.hpp"

namespace slam::scan_matching {

/// The likelihoods of a part of a map, in rasters of decreasing detail. Level k stores at each cell
/// the maximum over the 2^k x 2^k cells from this one on to the right and up: an upper bound of the
/// likelihood after any shift by less than 2^k cells (Hess, Kohler, Rapp, Andor 2016).
class LikelihoodPyramid {
 public:
  /// @param least, most the corners of the cells that it holds
  /// @param levels at least 1
  LikelihoodPyramid(const grid_map::GridMap& map, grid_map::CellIndex least,
                    grid_map::CellIndex most, int levels);

  int levels() const { return static_cast<int>(levels_.size()); }
  /// The index of a cell between least and most, in any level. Add width() for the next row up, and
  /// 1 for the next column to the right.
  std::int32_t at(grid_map::CellIndex cell) const {
    return (cell.y - least_.y) * width_ + (cell.x - least_.x);
  }
  std::int32_t width() const { return width_; }
  const std::uint8_t* level(int k) const { return levels_[static_cast<std::size_t>(k)].data(); }

 private:
  void fill(const grid_map::GridMap& map);

  grid_map::CellIndex least_;
  std::int32_t width_, height_;
  std::vector<std::vector<std::uint8_t>> levels_;
};

}  // namespace slam::scan_matching
