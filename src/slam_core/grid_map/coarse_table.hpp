// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam_core/grid_map/grid_map.hpp"

namespace slam::grid_map {

/// The likelihoods of a part of a map at a lower resolution: for each square of kSize cells the
/// largest in it and in those to its right, above, and above to the right. So it is at least that
/// of any cell to which a shift of less than kSize cells leads from one of the square (Olson 2009).
class CoarseTable {
 public:
  static constexpr int kBits = 3;
  static constexpr std::int32_t kSize = 1 << kBits;

  /// @param least, most cells that will be asked for
  CoarseTable(const GridMap& map, CellIndex least, CellIndex most);

  /// @param cell between those
  std::uint8_t at(CellIndex cell) const {
    const auto x = static_cast<std::size_t>((cell.x >> kBits) - x_);
    const auto y = static_cast<std::size_t>((cell.y >> kBits) - y_);
    return largest_[y * width_ + x];
  }

 private:
  std::uint8_t largestIn(const GridMap& map, CellIndex square) const;

  std::int32_t x_, y_;  ///< of the first square
  std::size_t width_, height_;
  std::vector<std::uint8_t> largest_;
};

}  // namespace slam::grid_map
