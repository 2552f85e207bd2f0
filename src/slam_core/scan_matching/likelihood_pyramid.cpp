// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/likelihood_pyramid.hpp"

#include <algorithm>

namespace slam::scan_matching {
namespace {

using grid_map::Tile;
using Raster = std::vector<std::uint8_t>;

/// Each cell and the one that lies `shift` behind it: the larger one. Nothing lies behind the last.
Raster largerOf(const Raster& cells, std::size_t shift) {
  Raster larger = cells;
  for (std::size_t i = 0; i + shift < cells.size(); ++i)
    larger[i] = std::max(cells[i], cells[i + shift]);
  return larger;
}

}  // namespace

LikelihoodPyramid::LikelihoodPyramid(const grid_map::GridMap& map, grid_map::CellIndex least,
                                     grid_map::CellIndex most, int levels)
    : least_(least), width_(most.x - least.x + 1), height_(most.y - least.y + 1) {
  fill(map);
  for (int k = 1; k < levels; ++k) {
    const auto half = std::size_t{1} << (k - 1);
    const auto row = static_cast<std::size_t>(width_);
    levels_.push_back(largerOf(largerOf(levels_.back(), half), half * row));
  }
}

void LikelihoodPyramid::fill(const grid_map::GridMap& map) {
  levels_.emplace_back(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  auto* cell = levels_.front().data();
  for (std::int32_t y = least_.y; y < least_.y + height_; ++y)
    for (std::int32_t x = least_.x; x < least_.x + width_;) {
      const auto in_tile = x & (Tile::kSize - 1);
      const auto count = std::min(Tile::kSize - in_tile, least_.x + width_ - x);
      if (const auto* const tile = map.tile({x, y}); tile != nullptr)
        std::copy_n(&tile->likelihood[Tile::at({x, y})], count, cell);
      cell += count;
      x += count;
    }
}

}  // namespace slam::scan_matching
