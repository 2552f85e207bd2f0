// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "slam_core/grid_map/copy_on_write.hpp"
#include "slam_core/grid_map/tile.hpp"

namespace slam::grid_map {

/// A rectangle of cells.
struct CellRectangle {
  CellIndex least;
  std::int32_t width = 0, height = 0;
};

/// Cells in tiles, of which there are only those that something has been written to. Copying a map
/// takes a pointer; what is written later is copied tile by tile. Different copies may be written
/// on different threads at the same time.
class GridMap {
 public:
  /// Counts the tiles of all maps that were copied from one another; must outlive them.
  class Memory {
   public:
    /// @param most_tiles in the rectangle that holds all that one map maps
    explicit Memory(std::size_t most_tiles = ~std::size_t{0}) : most_tiles_(most_tiles) {}
    std::size_t tilesInUse() const { return count_.inUse(); }
    std::size_t bytes() const { return tilesInUse() * sizeof(Tile); }

   private:
    friend class GridMap;
    TileCount count_;
    std::size_t most_tiles_;
  };

  explicit GridMap(Memory& memory) : memory_(&memory) {}

  /// Null where nothing has been mapped.
  const Tile* tile(CellIndex cell) const {
    const auto* const directory = directory_.get();
    return directory == nullptr ? nullptr : directory->tile(cell);
  }
  /// For writing, made where there is none. Null where the map would become too large.
  Tile* ownTile(CellIndex cell);
  /// The cell's tile becomes what it is in another copy of the map, which may be nothing.
  void restoreTile(CellIndex cell, const GridMap& from);

  LogOdds logOdds(CellIndex cell) const {
    const auto* const tile_of_cell = tile(cell);
    return tile_of_cell == nullptr ? kUnseen : tile_of_cell->log_odds[Tile::at(cell)];
  }

  /// A map that must grow grows by so many tiles beyond that which is written, if it may.
  static constexpr std::int32_t kMargin = 4;
  /// What holds all tiles.
  CellRectangle rectangle() const;
  /// The tiles of this map, counting those that it shares with others.
  std::size_t tiles() const;
  bool isEmpty() const { return directory_.get() == nullptr; }
  /// The same for copies of which none has been written since.
  const void* identity() const { return directory_.get(); }

  template <class Archive>
  void persist(Archive& archive) {
    directory_.persist(archive, memory_->count_);
  }

 private:
  struct Directory {
    std::int32_t x = 0, y = 0;  ///< of the first tile, in tiles
    std::int32_t width = 0, height = 0;
    std::vector<CopyOnWrite<Tile>> tiles;  ///< row by row

    bool holds(std::int32_t tile_x, std::int32_t tile_y) const {
      return tile_x >= x && tile_y >= y && tile_x - x < width && tile_y - y < height;
    }
    std::size_t at(std::int32_t tile_x, std::int32_t tile_y) const {
      return static_cast<std::size_t>(tile_y - y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(tile_x - x);
    }
    const Tile* tile(CellIndex cell) const {
      const std::int32_t tile_x = cell.x >> Tile::kBits, tile_y = cell.y >> Tile::kBits;
      return holds(tile_x, tile_y) ? tiles[at(tile_x, tile_y)].get() : nullptr;
    }

    template <class Archive>
    void persist(Archive& archive, TileCount& count) {
      archive(x, y, width, height);
      auto size = std::uint64_t{tiles.size()};
      archive.count(size);
      if constexpr (Archive::kReads) {
        if (width < 0 || height < 0 || size != std::uint64_t(width) * std::uint64_t(height))
          throw std::runtime_error("it holds a grid of another size: save it again");
        tiles.resize(size);
      }
      for (auto& tile : tiles) tile.persist(archive, count);
    }
  };

  bool grow(std::int32_t tile_x, std::int32_t tile_y);
  bool resize(std::int32_t x, std::int32_t y, std::int64_t width, std::int64_t height);

  Memory* memory_;
  CopyOnWrite<Directory> directory_;
};

}  // namespace slam::grid_map
