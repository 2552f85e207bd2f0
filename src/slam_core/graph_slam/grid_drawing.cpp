// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/grid_drawing.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/grid_map/beam_reading.hpp"
#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::graph_slam {

using grid_map::CellIndex;
using grid_map::Tile;

GridDrawing::GridDrawing(const grid_map::GridMapConfig& config, const grid_map::BeamModel& model,
                         const std::optional<OccupancyGrid>& base)
    : model_(model),
      most_tiles_(grid_map::mostTiles(config)),
      memory_(most_tiles_),
      base_(memory_),
      map_(memory_) {
  if (base) grid_map::fillFrom(*base, model_, base_);
  map_ = base_;
}

void GridDrawing::draw(const grid_map::ScanPoints& scan, const Pose2& pose) {
  depends_on_map_ =
      depends_on_map_ || std::any_of(scan.beams.begin(), scan.beams.end(), [](const auto& beam) {
        return grid_map::dependsOnMap(beam.sigma);
      });
  grid_map::drawScan(model_, scan, pose, nullptr, map_);
}

void GridDrawing::erase(const grid_map::ScanPoints& scan, const Pose2& pose) {
  constexpr std::size_t kMany = 1 << 16;  // who never asks for the drawing again makes no heap grow
  if (depends_on_map_) return;
  grid_map::addTilesOf(scan, pose, erased_);
  if (erased_.size() > kMany) grid_map::keepDistinct(erased_);
}

bool GridDrawing::clearErased() {
  if (depends_on_map_ || !fitsWith(erased_)) return false;
  cleared_.emplace(std::exchange(erased_, {}));
  for (const auto tile : cleared_->tiles())
    map_.restoreTile({tile.x * Tile::kSize, tile.y * Tile::kSize}, base_);
  return true;
}

/// Whether no map of these tiles and those that it has can grow too large, in whatever order it
/// does.
bool GridDrawing::fitsWith(const std::vector<CellIndex>& tiles) const {
  const auto map = map_.rectangle();
  const auto more = grid_map::rectangleOf(tiles);
  const auto edge = [](std::int32_t least, std::int32_t size, std::int32_t other,
                       std::int32_t other_size) {
    return static_cast<double>(std::max(least + size, other + other_size) - std::min(least, other) +
                               2 * grid_map::GridMap::kMargin);
  };
  const double width =
      edge(map.least.x / Tile::kSize, map.width / Tile::kSize, more.least.x, more.width);
  const double height =
      edge(map.least.y / Tile::kSize, map.height / Tile::kSize, more.least.y, more.height);
  return width * height <= static_cast<double>(most_tiles_);
}

bool GridDrawing::mayBeTouched(const Pose2& pose, double reach) const {
  const double tile = Tile::kSize * model_.resolution();
  const Eigen::Array2d least = (pose.position().array() - reach) / tile - 1.0;
  const Eigen::Array2d most = (pose.position().array() + reach) / tile + 1.0;
  constexpr double kMostTiles = 1 << 28;  // beyond, places have no numbers
  if (!(least.abs().maxCoeff() < kMostTiles && most.abs().maxCoeff() < kMostTiles)) return true;
  return cleared_->touches(grid_map::cellOf(least), grid_map::cellOf(most));
}

void GridDrawing::redraw(const grid_map::ScanPoints& scan, const Pose2& pose) {
  grid_map::drawScan(model_, scan, pose, &*cleared_, map_);
}

OccupancyGrid GridDrawing::grid() const {
  return grid_map::occupancyGridOf(map_, model_.resolution());
}

}  // namespace slam::graph_slam
