// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::scan_matching {
namespace {

using grid_map::Tile;

/// An end has to be near the middle of some cell.
grid_map::GridMapConfig inReach(grid_map::GridMapConfig config) {
  config.sigma = std::max(config.sigma, config.resolution);
  return config;
}

grid_map::GridMapConfig coarser(grid_map::GridMapConfig config) {
  config.resolution *= kCoarser;
  config.sigma *= kCoarser;
  return inReach(config);
}

}  // namespace

LevelModels levelModels(const grid_map::GridMapConfig& config) {
  return {grid_map::BeamModel(inReach(config)), grid_map::BeamModel(coarser(config))};
}

ScanLevels pointsOf(const LaserScan& scan, const LevelModels& models, double spacing) {
  return {grid_map::pointsOf(scan, models[0], spacing),
          grid_map::pointsOf(scan, models[1], kCoarser * spacing)};
}

double mostBytesFor(const ScanLevels& scan) {
  double tiles = 0.0;
  for (const auto& level : scan) {
    Eigen::AlignedBox2d box;
    for (const auto& fan : level.fans) box.extend(fan.origin);
    for (const auto& beam : level.beams) box.extend(beam.end);
    const Eigen::Vector2d size =
        box.isEmpty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(box.sizes());
    // in whatever direction it lies, and with a tile begun on either side
    const double diagonal = size.norm() / Tile::kSize + 2.0;
    const Eigen::Array2d edges = size.array() / Tile::kSize + 2.0;
    tiles += std::min(edges.prod() * 2.0, diagonal * diagonal);
  }
  return tiles * sizeof(Tile);
}

ScanMap::ScanMap(const grid_map::GridMapConfig& config)
    : memory_(grid_map::mostTiles(config)),
      levels_{Level{grid_map::BeamModel(inReach(config)), grid_map::GridMap(memory_)},
              Level{grid_map::BeamModel(coarser(config)), grid_map::GridMap(memory_)}} {}

std::size_t ScanMap::insert(const ScanLevels& scan, const Pose2& pose) {
  const std::size_t beyond = grid_map::insertScan(levels_[0].model, scan[0], pose, levels_[0].map);
  grid_map::insertScan(levels_[1].model, scan[1], pose, levels_[1].map);
  return beyond;
}

}  // namespace slam::scan_matching
