// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/coarse_table.hpp"

#include <algorithm>

namespace slam::grid_map {

CoarseTable::CoarseTable(const GridMap& map, CellIndex least, CellIndex most)
    : x_(least.x >> kBits),
      y_(least.y >> kBits),
      width_(static_cast<std::size_t>((most.x >> kBits) - x_ + 2)),
      height_(static_cast<std::size_t>((most.y >> kBits) - y_ + 2)),
      largest_(width_ * height_) {
  for (std::size_t y = 0; y < height_; ++y)
    for (std::size_t x = 0; x < width_; ++x)
      largest_[y * width_ + x] =
          largestIn(map, {x_ + static_cast<std::int32_t>(x), y_ + static_cast<std::int32_t>(y)});
  for (std::size_t y = 0; y < height_; ++y)
    for (std::size_t x = 0; x + 1 < width_; ++x)
      largest_[y * width_ + x] = std::max(largest_[y * width_ + x], largest_[y * width_ + x + 1]);
  for (std::size_t i = 0; i + width_ < largest_.size(); ++i)
    largest_[i] = std::max(largest_[i], largest_[i + width_]);
}

std::uint8_t CoarseTable::largestIn(const GridMap& map, CellIndex square) const {
  const CellIndex first{square.x * kSize, square.y * kSize};
  const auto* const tile = map.tile(first);
  if (tile == nullptr) return 0;
  const auto* const begin = &tile->likelihood[Tile::at(first)];
  std::uint8_t largest = 0;
  for (std::int32_t row = 0; row < kSize; ++row)
    for (std::int32_t column = 0; column < kSize; ++column)
      largest = std::max(largest, begin[row * Tile::kSize + column]);
  return largest;
}

}  // namespace slam::grid_map
