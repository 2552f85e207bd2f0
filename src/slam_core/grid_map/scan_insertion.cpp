// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "slam_core/grid_map/beam_reading.hpp"
#include "slam_core/grid_map/likelihood.hpp"

namespace slam::grid_map {
namespace {

/// The cells in which beams of one scan end.
class EndCells {
 public:
  explicit EndCells(std::size_t most) {
    std::size_t size = 16;
    while (size < 4 * most) size *= 2;
    cells_.resize(size, kNone);
  }
  void add(CellIndex cell) { cells_[slotOf(cell)] = keyOf(cell); }
  bool contains(CellIndex cell) const { return cells_[slotOf(cell)] != kNone; }

 private:
  /// Of a cell far beyond those that a map has.
  static constexpr std::uint64_t kNone = std::uint64_t{0x80000000} << 32 | 0x80000000;
  static std::uint64_t keyOf(CellIndex cell) {
    return std::uint64_t{static_cast<std::uint32_t>(cell.x)} << 32 |
           static_cast<std::uint32_t>(cell.y);
  }
  std::size_t slotOf(CellIndex cell) const {
    const auto key = keyOf(cell);
    auto slot = (key * 0x9E3779B97F4A7C15u) >> 40 & (cells_.size() - 1);
    while (cells_[slot] != kNone && cells_[slot] != key) slot = (slot + 1) & (cells_.size() - 1);
    return slot;
  }
  std::vector<std::uint64_t> cells_;
};

CellIndex tileOf(CellIndex cell) { return {cell.x >> Tile::kBits, cell.y >> Tile::kBits}; }

/// A scan goes into all tiles, as a map needs them to match other scans with it.
struct ToMatch {
  static constexpr bool kHasLikelihood = true;
  bool contains(CellIndex) const { return true; }
};

/// A scan goes into some tiles, or all, of which nobody asks how likely a beam ends there.
struct ToShow {
  static constexpr bool kHasLikelihood = false;
  const TileSet* among;  ///< null: all
  bool contains(CellIndex tile) const { return among == nullptr || among->contains(tile); }
};

/// The tile written last, so that neighbouring cells need no search.
template <class Tiles>
class TileCursor {
 public:
  TileCursor(GridMap& map, const Tiles& tiles) : map_(map), tiles_(tiles) {}

  /// Whether the scan goes into the cell's tile; to be called before the others.
  bool moveTo(CellIndex cell) {
    const CellIndex tile = tileOf(cell);
    if (is_set_ && tile == tile_) return is_taken_;
    is_set_ = true;
    tile_ = tile;
    is_taken_ = tiles_.contains(tile);
    read_ = is_taken_ ? map_.tile(cell) : nullptr;
    own_ = nullptr;
    return is_taken_;
  }
  const Tile* read() const { return read_; }
  Tile* own(CellIndex cell) {
    if (own_ == nullptr) read_ = own_ = map_.ownTile(cell);
    return own_;
  }

 private:
  GridMap& map_;
  const Tiles& tiles_;
  CellIndex tile_;
  bool is_set_ = false, is_taken_ = false;
  const Tile* read_ = nullptr;
  Tile* own_ = nullptr;
};

/// Calls visit(cell) for those from one to another, without the last (Bresenham 1965).
template <class Visit>
void traverse(CellIndex from, CellIndex to, const Visit& visit) {
  const std::int32_t dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
  const std::int32_t step_x = from.x < to.x ? 1 : -1, step_y = from.y < to.y ? 1 : -1;
  std::int32_t error = dx + dy;
  while (!(from == to)) {
    visit(from);
    const std::int32_t twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      from.x += step_x;
    }
    if (twice <= dx) {
      error += dx;
      from.y += step_y;
    }
  }
}

template <class Tiles>
class Insertion {
 public:
  Insertion(const BeamModel& model, const ScanPoints& scan, const Pose2& pose, const Tiles& tiles,
            GridMap& map)
      : model_(model),
        scan_(scan),
        pose_(pose),
        tiles_(tiles),
        map_(map),
        cursor_(map, tiles_),
        ends_(scan.beams.size()) {}

  std::size_t run() {
    std::vector<BeamReading> readings;
    readings.reserve(scan_.beams.size());
    scan_.forEachFan([&](const auto& fan, const auto& beams, const auto&) {
      const Eigen::Vector2d origin = pose_.transform(fan.origin);
      for (const auto& beam : beams) {
        readings.push_back(readingOf(origin, pose_.transform(beam.end), beam.sigma, map_));
        if (beam.isHit()) ends_.add(readings.back().hit);
      }
    });
    auto reading = readings.begin();
    scan_.forEachFan([&](const auto& fan, const auto& beams, const auto&) {
      const auto from = cellOf(pose_.transform(fan.origin));
      for (std::size_t left = beams.size(); left > 0; --left)
        traverse(from, (reading++)->free_to, [&](CellIndex cell) { miss(cell); });
    });
    for (std::size_t k = 0; k < readings.size(); ++k)
      if (scan_.beams[k].isHit()) hit(readings[k], scan_.beams[k].gain);
    if constexpr (Tiles::kHasLikelihood)
      for (const auto cell : freed_) takeLikelihood(model_, cell, map_);
    return beyond_;
  }

 private:
  void miss(CellIndex cell) {
    if (!cursor_.moveTo(cell)) return;
    const auto* const tile = cursor_.read();
    const auto at = Tile::at(cell);
    const LogOdds before = tile == nullptr ? kUnseen : tile->log_odds[at];
    const LogOdds after = model_.afterMiss(before);
    if (after == before || ends_.contains(cell)) return;
    auto* const own = cursor_.own(cell);
    if (own == nullptr) return;
    own->log_odds[at] = after;
    if (BeamModel::isOccupied(before) && !BeamModel::isOccupied(after)) {
      own->ends[at] = 0;
      if constexpr (Tiles::kHasLikelihood) freed_.push_back(cell);
    }
  }

  void hit(const BeamReading& reading, LogOdds gain) {
    const auto& [end, cell, free_to] = reading;
    if (!cursor_.moveTo(cell)) return;
    const auto at = Tile::at(cell);
    const auto* const tile = cursor_.read();
    const LogOdds before = tile == nullptr ? kUnseen : tile->log_odds[at];
    const LogOdds after = model_.afterHit(before, gain);
    if (after == before && tile->ends[at] >= kMostEnds) return;
    auto* const own = cursor_.own(cell);
    if (own == nullptr) {
      ++beyond_;
      return;
    }
    own->log_odds[at] = after;
    if (own->ends[at] < kMostEnds) {
      const int n = ++own->ends[at];
      own->mean_x[at] = moved(own->mean_x[at], end.x() - cell.x, n);
      own->mean_y[at] = moved(own->mean_y[at], end.y() - cell.y, n);
      if (BeamModel::isOccupied(after)) give(cell);
    } else if (!BeamModel::isOccupied(before) && BeamModel::isOccupied(after)) {
      give(cell);
    }
  }

  void give([[maybe_unused]] CellIndex cell) {
    if constexpr (Tiles::kHasLikelihood) giveLikelihood(model_, cell, map_);
  }

  static std::int8_t moved(std::int8_t mean, double end, int n) {
    const double offset = 256.0 * (end - 0.5);
    return static_cast<std::int8_t>(
        std::clamp(std::lround(mean + (offset - mean) / n), -128l, 127l));
  }

  static constexpr std::uint8_t kMostEnds = 20;
  const BeamModel& model_;
  const ScanPoints& scan_;
  const Pose2 pose_;
  const Tiles tiles_;
  GridMap& map_;
  TileCursor<Tiles> cursor_;
  EndCells ends_;
  std::vector<CellIndex> freed_;
  std::size_t beyond_ = 0;
};

/// The beams that may write to some of the tiles.
ScanPoints partAmong(const TileSet& tiles, const ScanPoints& scan, const Pose2& in_cells) {
  ScanPoints part;
  scan.forEachFan([&](const auto& fan, const auto& beams, const auto&) {
    part.startFan(fan.origin, fan.relative_sigma);
    const auto from = tileOf(cellOf(in_cells.transform(fan.origin)));
    for (const auto& beam : beams)
      if (tiles.touches(from, tileOf(cellOf(in_cells.transform(beam.end)))))
        part.beams.push_back(beam);
  });
  return part;
}

}  // namespace

std::size_t insertScan(const BeamModel& model, const ScanPoints& scan, const Pose2& pose,
                       GridMap& map) {
  if (!scan.isOnMap(pose)) return scan.beams.size();
  return Insertion(model, scan, scan.inCells(pose), ToMatch(), map).run();
}

void drawScan(const BeamModel& model, const ScanPoints& scan, const Pose2& pose,
              const TileSet* among, GridMap& map) {
  if (!scan.isOnMap(pose)) return;
  const Pose2 in_cells = scan.inCells(pose);
  if (among == nullptr)
    Insertion(model, scan, in_cells, ToShow{among}, map).run();
  else if (const auto part = partAmong(*among, scan, in_cells); !part.beams.empty())
    Insertion(model, part, in_cells, ToShow{among}, map).run();
}

void addTilesOf(const ScanPoints& scan, const Pose2& pose, std::vector<CellIndex>& tiles) {
  if (!scan.isOnMap(pose) || scan.beams.empty()) return;
  const Pose2 in_cells = scan.inCells(pose);
  std::vector<CellIndex> corners;
  for (const auto& fan : scan.fans)
    corners.push_back(tileOf(cellOf(in_cells.transform(fan.origin))));
  for (const auto& beam : scan.beams)
    corners.push_back(tileOf(cellOf(in_cells.transform(beam.end))));
  const auto [least, width, height] = rectangleOf(corners);
  std::vector<bool> is_added(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto add = [&, least = least, width = width](CellIndex cell) {
    const auto tile = tileOf(cell);
    const auto at = static_cast<std::size_t>(tile.y - least.y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(tile.x - least.x);
    if (!is_added[at]) tiles.push_back(tile);
    is_added[at] = true;
  };
  scan.forEachFan([&](const auto& fan, const auto& beams, const auto&) {
    const auto from = cellOf(in_cells.transform(fan.origin));
    for (const auto& beam : beams) {
      const auto end = cellOf(in_cells.transform(beam.end));
      traverse(from, end, add);
      if (beam.isHit()) add(end);
    }
  });
}

}  // namespace slam::grid_map
