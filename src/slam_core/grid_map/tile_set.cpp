// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/tile_set.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace slam::grid_map {

CellRectangle rectangleOf(const std::vector<CellIndex>& tiles) {
  if (tiles.empty()) return {};
  CellIndex least = tiles.front(), most = least;
  for (const auto tile : tiles) {
    least = {std::min(least.x, tile.x), std::min(least.y, tile.y)};
    most = {std::max(most.x, tile.x), std::max(most.y, tile.y)};
  }
  return {least, most.x - least.x + 1, most.y - least.y + 1};
}

void keepDistinct(std::vector<CellIndex>& tiles) {
  std::sort(tiles.begin(), tiles.end(),
            [](CellIndex a, CellIndex b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

TileSet::TileSet(std::vector<CellIndex> tiles)
    : tiles_(std::move(tiles)), rectangle_(rectangleOf(tiles_)) {
  keepDistinct(tiles_);
  sums_.resize(at(0, rectangle_.height + 1));
  for (const auto tile : tiles_)
    ++sums_[at(tile.x - rectangle_.least.x + 1, tile.y - rectangle_.least.y + 1)];
  for (std::int32_t y = 1; y <= rectangle_.height; ++y)
    for (std::int32_t x = 1; x <= rectangle_.width; ++x)
      sums_[at(x, y)] += sums_[at(x - 1, y)] + sums_[at(x, y - 1)] - sums_[at(x - 1, y - 1)];
}

bool TileSet::touches(CellIndex a, CellIndex b) const {
  const auto [left, right] = std::minmax({a.x - rectangle_.least.x, b.x - rectangle_.least.x});
  const auto [below, above] = std::minmax({a.y - rectangle_.least.y, b.y - rectangle_.least.y});
  const std::int32_t x0 = std::max(left, 0), x1 = std::min(right + 1, rectangle_.width);
  const std::int32_t y0 = std::max(below, 0), y1 = std::min(above + 1, rectangle_.height);
  if (x0 >= x1 || y0 >= y1) return false;
  return sums_[at(x1, y1)] - sums_[at(x0, y1)] - sums_[at(x1, y0)] + sums_[at(x0, y0)] > 0;
}

}  // namespace slam::grid_map
