// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_map.hpp"

#include <algorithm>
#include <utility>

namespace slam::grid_map {

Tile* GridMap::ownTile(CellIndex cell) {
  const std::int32_t tile_x = cell.x >> Tile::kBits, tile_y = cell.y >> Tile::kBits;
  const auto* const directory = directory_.get();
  if (directory == nullptr || !directory->holds(tile_x, tile_y))
    if (!grow(tile_x, tile_y)) return nullptr;
  auto& own = directory_.own();
  return &own.tiles[own.at(tile_x, tile_y)].own(memory_->count_);
}

void GridMap::restoreTile(CellIndex cell, const GridMap& from) {
  const std::int32_t tile_x = cell.x >> Tile::kBits, tile_y = cell.y >> Tile::kBits;
  const auto* const directory = directory_.get();
  if (directory == nullptr || !directory->holds(tile_x, tile_y)) return;
  const auto* const other = from.directory_.get();
  const bool is_there = other != nullptr && other->holds(tile_x, tile_y);
  auto tile = is_there ? other->tiles[other->at(tile_x, tile_y)] : CopyOnWrite<Tile>();
  auto& own = directory_.own();
  own.tiles[own.at(tile_x, tile_y)] = std::move(tile);
}

/// Makes room for a tile and some more beyond it, if that is not too much.
bool GridMap::grow(std::int32_t tile_x, std::int32_t tile_y) {
  const auto* const old = directory_.get();
  if (old == nullptr) return resize(tile_x, tile_y, 1, 1);
  for (const std::int32_t margin : {kMargin, 0}) {
    const auto x = tile_x < old->x ? tile_x - margin : old->x;
    const auto y = tile_y < old->y ? tile_y - margin : old->y;
    const auto right = std::int64_t{old->x} + old->width, top = std::int64_t{old->y} + old->height;
    const auto width = (tile_x < right ? right : std::int64_t{tile_x} + 1 + margin) - x;
    const auto height = (tile_y < top ? top : std::int64_t{tile_y} + 1 + margin) - y;
    if (resize(x, y, width, height)) return true;
  }
  return false;
}

bool GridMap::resize(std::int32_t x, std::int32_t y, std::int64_t width, std::int64_t height) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (count > memory_->most_tiles_) return false;
  Directory larger{x, y, static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), {}};
  larger.tiles.resize(count);
  if (const auto* const old = directory_.get())
    for (std::int32_t row = 0; row < old->height; ++row)
      std::copy_n(
          old->tiles.begin() + row * old->width, old->width,
          larger.tiles.begin() + static_cast<std::ptrdiff_t>(larger.at(old->x, old->y + row)));
  directory_ = {};
  directory_.own() = std::move(larger);
  return true;
}

CellRectangle GridMap::rectangle() const {
  const auto* const directory = directory_.get();
  if (directory == nullptr) return {};
  return {{directory->x * Tile::kSize, directory->y * Tile::kSize},
          directory->width * Tile::kSize,
          directory->height * Tile::kSize};
}

std::size_t GridMap::tiles() const {
  const auto* const directory = directory_.get();
  if (directory == nullptr) return 0;
  const auto exists = [](const CopyOnWrite<Tile>& tile) { return tile.get() != nullptr; };
  return static_cast<std::size_t>(
      std::count_if(directory->tiles.begin(), directory->tiles.end(), exists));
}

}  // namespace slam::grid_map
