// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/grid_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::graph_slam {

GridRenderer::GridRenderer(const grid_map::GridMapConfig& config)
    : config_(config), model_(scan_matching::levelModels(config)[0]) {}

void GridRenderer::startWith(const OccupancyGrid& grid) {
  base_ = grid;
  drawing_.reset();
  ++revision_;
}

void GridRenderer::add(graph::Key node, const Pose2& pose, const SharedScan& scan) {
  scans_.push_back({node, pose, scan});
  ++revision_;
}

void GridRenderer::follow(const graph::Optimizer& graph) {
  constexpr double kLargestTurn = 0.01;  // half a cell of 5 cm at 2.5 m [rad]
  const double most = 0.5 * config_.resolution;
  bool has_moved = false;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const Pose2 now = graph.pose(scans_[i].node);
    const Pose2 moved = scans_[i].pose.between(now);
    if (moved.position().norm() <= most && std::abs(moved.theta()) <= kLargestTurn) continue;
    scans_[i].pose = now;
    has_moved = true;
    if (i < drawn_) drawing_.reset();
  }
  if (has_moved) ++revision_;
}

void GridRenderer::draw() const {
  if (!drawing_) {
    drawing_ = std::make_unique<scan_matching::ScanMap>(config_);
    drawn_ = 0;
    if (base_) grid_map::fillFrom(*base_, model_, drawing_->level(0).map);
  }
  auto& map = drawing_->level(0).map;
  constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
  for (; drawn_ < scans_.size(); ++drawn_) {
    const auto& [node, pose, scan] = scans_[drawn_];
    grid_map::insertScan(model_, grid_map::pointsOf(*scan, model_, kNoMatter), pose, map);
  }
}

OccupancyGrid GridRenderer::grid() const {
  if (scans_.empty() && !base_) {
    OccupancyGrid nothing;
    nothing.resolution = model_.resolution();
    return nothing;
  }
  draw();
  return grid_map::occupancyGridOf(drawing_->finest().map, model_.resolution());
}

std::size_t GridRenderer::bytes() const {
  std::size_t sum = drawing_ ? drawing_->bytes() : 0;
  for (const auto& [node, pose, scan] : scans_) sum += scan->beams.size() * sizeof(LaserBeam);
  return sum;
}

}  // namespace slam::graph_slam
