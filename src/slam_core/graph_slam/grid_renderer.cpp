// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/grid_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::graph_slam {

GridRenderer::GridRenderer(const grid_map::GridMapConfig& config)
    : config_(config), model_(scan_matching::levelModels(config)[0]) {}

void GridRenderer::startWith(const OccupancyGrid& grid) {
  base_ = grid;
  drawing_.reset();
  ++revision_;
}

void GridRenderer::add(graph::Key node, const Pose2& pose, const grid_map::ScanPoints& scan) {
  scans_.push_back({node, pose, scan});
  scans_.back().points.ends.clear();  // they are for matching
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
  for (; drawn_ < scans_.size(); ++drawn_)
    grid_map::insertScan(model_, scans_[drawn_].points, scans_[drawn_].pose, map);
}

std::optional<OccupancyGrid> GridRenderer::grid() const {
  if (scans_.empty() && !base_) return std::nullopt;
  draw();
  return grid_map::occupancyGridOf(drawing_->finest().map, model_.resolution());
}

double GridRenderer::bytes() const {
  double sum = 0.0;
  for (const auto& scan : scans_)
    sum += static_cast<double>(scan.points.beams.size() * sizeof(grid_map::ScanPoints::Beam));
  return sum;
}

}  // namespace slam::graph_slam
