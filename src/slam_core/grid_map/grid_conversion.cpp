// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_conversion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "slam_core/grid_map/likelihood.hpp"

namespace slam::grid_map {
namespace {

double probabilityOf(LogOdds cell) { return 1.0 / (1.0 + std::exp(-cell / kLogOddsUnit)); }

/// The percentage of each value that a cell can have, by its bits.
std::array<std::int8_t, 256> percentages() {
  std::array<std::int8_t, 256> percent;
  for (int cell = -128; cell <= 127; ++cell)
    percent[static_cast<std::uint8_t>(cell)] =
        static_cast<std::int8_t>(std::lround(100.0 * probabilityOf(static_cast<LogOdds>(cell))));
  return percent;
}

/// Calls visit(cell, log odds) for each that has been seen, row by row.
template <class Visit>
void forEachSeen(const GridMap& map, const Visit& visit) {
  const auto all = map.rectangle();
  for (std::int32_t y = all.least.y; y < all.least.y + all.height; ++y)
    for (std::int32_t left = all.least.x; left < all.least.x + all.width; left += Tile::kSize) {
      const auto* const tile = map.tile({left, y});
      if (tile == nullptr) continue;
      const auto* const row = tile->log_odds.data() + Tile::at({left, y});
      for (std::int32_t i = 0; i < Tile::kSize; ++i)
        if (row[i] != kUnseen) visit(CellIndex{left + i, y}, row[i]);
    }
}

struct Bounds {
  CellIndex least{INT32_MAX, INT32_MAX}, most{INT32_MIN, INT32_MIN};
  bool isEmpty() const { return most.x < least.x; }
};

Bounds boundsOfSeen(const GridMap& map) {
  Bounds bounds;
  forEachSeen(map, [&](CellIndex cell, LogOdds) {
    bounds.least = {std::min(bounds.least.x, cell.x), std::min(bounds.least.y, cell.y)};
    bounds.most = {std::max(bounds.most.x, cell.x), std::max(bounds.most.y, cell.y)};
  });
  return bounds;
}

/// Percent to log odds, not beyond what the model lets a cell have.
LogOdds logOddsOf(std::int8_t percent, const BeamModel& model) {
  const double p = std::clamp(percent / 100.0, 1e-3, 1.0 - 1e-3);
  const long value = std::lround(kLogOddsUnit * std::log(p / (1.0 - p)));
  const long most = model.largestLogOdds();
  return static_cast<LogOdds>(std::clamp(value, -most, most));
}

bool canBeRead(const OccupancyGrid& grid, const BeamModel& model) {
  constexpr double kMostCells = 1 << 28, kMostOfOurs = 1000.0;
  const double cells = grid.resolution / model.resolution();  // of ours along the edge of theirs
  const Eigen::Vector2d end =
      grid.origin + grid.resolution * Eigen::Vector2d(grid.width, grid.height);
  return grid.resolution > 0.0 && cells < kMostOfOurs &&
         grid.cells.size() == std::size_t{grid.width} * grid.height && grid.origin.allFinite() &&
         grid.origin.cwiseAbs().maxCoeff() < kMostCells * model.resolution() &&
         end.cwiseAbs().maxCoeff() < kMostCells * model.resolution();
}

/// What a grid shows goes into an empty map.
class Filling {
 public:
  Filling(const OccupancyGrid& grid, const BeamModel& model, GridMap& map)
      : grid_(grid), model_(model), map_(map) {}

  /// Whether all of it had room.
  bool run() {
    for (std::uint32_t row = 0; row < grid_.height; ++row)
      for (std::uint32_t column = 0; column < grid_.width; ++column) {
        const auto percent = grid_.cells[std::size_t{row} * grid_.width + column];
        if (percent != OccupancyGrid::kUnknown) fill(column, row, logOddsOf(percent, model_));
      }
    for (const auto cell : occupied_) giveLikelihood(model_, cell, map_);
    return has_room_;
  }

 private:
  /// The cells of ours that one of the grid touches.
  void fill(std::uint32_t column, std::uint32_t row, LogOdds log_odds) {
    const auto [x0, x1] = touched(grid_.origin.x(), column);
    const auto [y0, y1] = touched(grid_.origin.y(), row);
    for (std::int32_t y = y0; y <= y1; ++y)
      for (std::int32_t x = x0; x <= x1; ++x) {
        auto* const tile = map_.ownTile({x, y});
        has_room_ &= tile != nullptr;
        if (tile == nullptr) continue;
        auto& cell = tile->log_odds[Tile::at({x, y})];
        cell = std::max(cell, log_odds);
        if (BeamModel::isOccupied(cell)) occupied_.push_back({x, y});
      }
  }

  /// First and last of our cells along one axis.
  std::pair<std::int32_t, std::int32_t> touched(double origin, std::uint32_t i) const {
    constexpr double kRounding = 1e-6;
    const double begin = (origin + i * grid_.resolution) / model_.resolution();
    const double end = (origin + (i + 1.0) * grid_.resolution) / model_.resolution();
    return {static_cast<std::int32_t>(std::floor(begin + kRounding)),
            static_cast<std::int32_t>(std::ceil(end - kRounding)) - 1};
  }

  const OccupancyGrid& grid_;
  const BeamModel& model_;
  GridMap& map_;
  std::vector<CellIndex> occupied_;
  bool has_room_ = true;
};

}  // namespace

OccupancyGrid occupancyGridOf(const GridMap& map, double resolution) {
  OccupancyGrid grid;
  grid.resolution = resolution;
  const auto bounds = boundsOfSeen(map);
  if (bounds.isEmpty()) return grid;
  grid.origin = resolution * Eigen::Vector2d(bounds.least.x, bounds.least.y);
  grid.width = static_cast<std::uint32_t>(bounds.most.x - bounds.least.x + 1);
  grid.height = static_cast<std::uint32_t>(bounds.most.y - bounds.least.y + 1);
  grid.cells.assign(std::size_t{grid.width} * grid.height, OccupancyGrid::kUnknown);
  static const auto kPercent = percentages();
  forEachSeen(map, [&](CellIndex cell, LogOdds log_odds) {
    const auto x = static_cast<std::size_t>(cell.x - bounds.least.x);
    const auto y = static_cast<std::size_t>(cell.y - bounds.least.y);
    grid.cells[y * grid.width + x] = kPercent[static_cast<std::uint8_t>(log_odds)];
  });
  return grid;
}

Status fillFrom(const OccupancyGrid& grid, const BeamModel& model, GridMap& map) {
  if (!canBeRead(grid, model))
    return Status::error(
        "the grid map cannot be used: its size, resolution or origin is not that of a map");
  Filling filling(grid, model, map);
  if (filling.run()) return Status::ok();
  return Status::warning(
      "the grid map is larger than grid_map.largest_area, not all of it is used: raise that");
}

double entropyOf(const GridMap& map) {
  double sum = 0.0;
  forEachSeen(map, [&](CellIndex, LogOdds cell) {
    const double p = probabilityOf(cell);
    sum -= p * std::log2(p) + (1.0 - p) * std::log2(1.0 - p);
  });
  return sum;
}

}  // namespace slam::grid_map
