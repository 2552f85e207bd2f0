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
  scan_bytes_ += static_cast<double>(scan->beams.size() * sizeof(LaserBeam));
  cover(scans_.back());
  ++revision_;
}

void GridRenderer::remove(graph::Key node) {
  const auto found = std::find_if(scans_.begin(), scans_.end(),
                                  [node](const Scan& scan) { return scan.node == node; });
  if (found == scans_.end()) return;
  if (static_cast<std::size_t>(found - scans_.begin()) < drawn_) drawing_.reset();
  scan_bytes_ -= static_cast<double>(found->scan->beams.size() * sizeof(LaserBeam));
  scans_.erase(found);
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
    cover(scans_[i]);
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

void GridRenderer::cover(const Scan& scan) {
  double furthest = 0.0;
  for (const auto& beam : scan.scan->beams)
    furthest = std::max(furthest, static_cast<double>(beam.range));
  const double reach =
      std::min(furthest, config_.usable_range) + scan.scan->sensor_pose.position().norm();
  covered_.extend(scan.pose.position() - Eigen::Vector2d::Constant(reach));
  covered_.extend(scan.pose.position() + Eigen::Vector2d::Constant(reach));
}

double GridRenderer::mostBytes() const {
  if (scans_.empty()) return 0.0;
  const double edge = config_.resolution * grid_map::Tile::kSize;
  const Eigen::Array2d tiles = covered_.sizes().array() / edge + 2.0;
  const double most = std::min(tiles.prod(), static_cast<double>(grid_map::mostTiles(config_)));
  return scan_bytes_ + most * sizeof(grid_map::Tile);
}

}  // namespace slam::graph_slam
