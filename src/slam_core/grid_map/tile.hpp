// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace slam::grid_map {

/// A cell by its column and row; cell (0, 0) has its lower left corner in the map's origin.
struct CellIndex {
  std::int32_t x = 0, y = 0;
  bool operator==(const CellIndex& other) const { return x == other.x && y == other.y; }
};

/// Logarithm of the odds that a cell is occupied, in units of 1/kLogOddsUnit; kUnseen where no beam
/// has shown anything.
using LogOdds = std::int8_t;
constexpr double kLogOddsUnit = 16.0;
constexpr LogOdds kUnseen = -128;

/// How many tiles there are, whichever maps they belong to. For several threads at once.
class TileCount {
 public:
  std::size_t inUse() const { return in_use_.load(std::memory_order_relaxed); }

 private:
  friend class CountedTile;
  std::atomic<std::size_t> in_use_{0};
};

/// Counts itself as long as it lives.
class CountedTile {
 public:
  CountedTile() = default;
  explicit CountedTile(TileCount& count) : count_(&count) { add(); }
  CountedTile(const CountedTile& other) : count_(other.count_) { add(); }
  CountedTile& operator=(const CountedTile&) = delete;
  ~CountedTile() {
    if (count_ != nullptr) count_->in_use_.fetch_sub(1, std::memory_order_relaxed);
  }

 private:
  void add() {
    if (count_ != nullptr) count_->in_use_.fetch_add(1, std::memory_order_relaxed);
  }
  TileCount* count_ = nullptr;
};

/// A square part of a map, its cells row by row. Each property has an array of its own: matching
/// reads the likelihood only.
struct Tile : CountedTile {
  static constexpr int kBits = 4;
  static constexpr std::int32_t kSize = 1 << kBits;
  static constexpr std::size_t kCells = std::size_t{kSize} * kSize;

  explicit Tile(TileCount& count) : CountedTile(count) { log_odds.fill(kUnseen); }

  static std::size_t at(CellIndex cell) {
    return static_cast<std::size_t>(cell.y & (kSize - 1)) * kSize +
           static_cast<std::size_t>(cell.x & (kSize - 1));
  }

  /// How likely a beam ends in the middle of the cell, relative to the best place; 255 stands
  /// for 1.
  std::array<std::uint8_t, kCells> likelihood{};
  std::array<LogOdds, kCells> log_odds;
  /// Mean of the ends of beams in the cell, in 1/256 of a cell from its middle, and how many of
  /// them there were.
  std::array<std::int8_t, kCells> mean_x{}, mean_y{};
  std::array<std::uint8_t, kCells> ends{};

  template <class Archive>
  void persist(Archive& archive, TileCount& /*count*/) {
    archive(likelihood, log_odds, mean_x, mean_y, ends);
  }
};

}  // namespace slam::grid_map
