// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_map.hpp"

#include <algorithm>

#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::scan_matching {
namespace {

grid_map::GridMapConfig coarser(grid_map::GridMapConfig config) {
  config.resolution *= kCoarser;
  // an end has to be near the middle of some cell
  config.sigma = std::max(kCoarser * config.sigma, config.resolution);
  return config;
}

}  // namespace

LevelModels levelModels(const grid_map::GridMapConfig& config) {
  return {grid_map::BeamModel(config), grid_map::BeamModel(coarser(config))};
}

ScanLevels pointsOf(const LaserScan& scan, const LevelModels& models, double spacing) {
  return {grid_map::pointsOf(scan, models[0], spacing),
          grid_map::pointsOf(scan, models[1], kCoarser * spacing)};
}

ScanMap::ScanMap(const grid_map::GridMapConfig& config)
    : memory_(grid_map::mostTiles(config)),
      levels_{Level{grid_map::BeamModel(config), grid_map::GridMap(memory_)},
              Level{grid_map::BeamModel(coarser(config)), grid_map::GridMap(memory_)}} {}

std::size_t ScanMap::insert(const ScanLevels& scan, const Pose2& pose) {
  const std::size_t beyond = grid_map::insertScan(levels_[0].model, scan[0], pose, levels_[0].map);
  grid_map::insertScan(levels_[1].model, scan[1], pose, levels_[1].map);
  return beyond;
}

}  // namespace slam::scan_matching
