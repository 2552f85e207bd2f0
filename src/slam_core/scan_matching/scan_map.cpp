// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_map.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::scan_matching {
namespace {

/// Of the rectangle of a map in its finest resolution; the coarser ones need less.
std::size_t mostTiles(const grid_map::GridMapConfig& config) {
  const double edge = grid_map::Tile::kSize * config.resolution;
  return static_cast<std::size_t>(std::ceil(config.largest_area / (edge * edge)));
}

}  // namespace

ScanMap::Level ScanMap::levelOf(grid_map::GridMapConfig config, double coarser,
                                grid_map::GridMap::Memory& memory) {
  config.resolution *= coarser;
  // an end has to be near the middle of some cell
  config.sigma = std::max(coarser * config.sigma, config.resolution);
  return {grid_map::BeamModel(config), grid_map::GridMap(memory)};
}

ScanMap::ScanMap(const grid_map::GridMapConfig& config)
    : memory_(mostTiles(config)),
      levels_{levelOf(config, 1.0, memory_), levelOf(config, kCoarser, memory_)} {}

ScanLevels ScanMap::pointsOf(const LaserScan& scan, double spacing) const {
  return {grid_map::pointsOf(scan, levels_[0].model, spacing),
          grid_map::pointsOf(scan, levels_[1].model, kCoarser * spacing)};
}

std::size_t ScanMap::insert(const ScanLevels& scan, const Pose2& pose) {
  const std::size_t beyond = grid_map::insertScan(levels_[0].model, scan[0], pose, levels_[0].map);
  grid_map::insertScan(levels_[1].model, scan[1], pose, levels_[1].map);
  return beyond;
}

}  // namespace slam::scan_matching
