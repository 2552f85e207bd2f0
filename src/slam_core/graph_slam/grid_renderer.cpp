// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/grid_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::graph_slam {
namespace {

/// @return the memory that the beams of a scan take [bytes]
double beamBytesOf(const LaserScan& scan) {
  std::size_t beams = 0;
  forEachFan(scan, [&](const LaserFan& fan) { beams += fan.beams.size(); });
  return static_cast<double>(beams * sizeof(LaserBeam));
}

}  // namespace

GridRenderer::GridRenderer(const grid_map::GridMapConfig& config)
    : config_(config), model_(scan_matching::levelModels(config)[0]) {}

void GridRenderer::startWith(const OccupancyGrid& grid) {
  base_ = grid;
  drawing_.reset();
  drawn_.clear();
  ++revision_;
}

void GridRenderer::add(graph::Key node, const Pose2& pose, const SharedScan& scan) {
  scans_.push_back({node, pose, scan, reachOf(*scan)});
  scan_bytes_ += beamBytesOf(*scan);
  cover(scans_.back());
  ++revision_;
}

void GridRenderer::remove(graph::Key node) {
  const auto found = std::find_if(scans_.begin(), scans_.end(),
                                  [node](const Scan& scan) { return scan.node == node; });
  if (found == scans_.end()) return;
  const auto at = found - scans_.begin();
  if (at < static_cast<std::ptrdiff_t>(drawn_.size())) {
    drawing_->erase(pointsOf(*found), drawn_[static_cast<std::size_t>(at)]);
    drawn_.erase(drawn_.begin() + at);
    is_erased_ = true;
  }
  scan_bytes_ -= beamBytesOf(*found->scan);
  scans_.erase(found);
  ++revision_;
}

void GridRenderer::follow(const graph::Optimizer& graph) {
  constexpr double kLargestTurn = 0.01;  // half a cell of 5 cm at 2.5 m [rad]
  const double most = 0.5 * config_.resolution;
  bool has_moved = false;
  for (auto& scan : scans_) {
    const Pose2 now = graph.pose(scan.node);
    const Pose2 moved = scan.pose.between(now);
    if (moved.position().norm() <= most && std::abs(moved.theta()) <= kLargestTurn) continue;
    scan.pose = now;
    cover(scan);
    has_moved = true;
  }
  if (has_moved) ++revision_;
}

grid_map::ScanPoints GridRenderer::pointsOf(const Scan& scan) const {
  constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
  return grid_map::pointsOf(*scan.scan, model_, kNoMatter);
}

/// @return false where that takes a new drawing
bool GridRenderer::redrawMoved() const {
  bool has_changed = std::exchange(is_erased_, false);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const auto& now = scans_[i].pose;
    if (drawn_[i].vector() == now.vector()) continue;
    const auto points = pointsOf(scans_[i]);
    drawing_->erase(points, std::exchange(drawn_[i], now));
    drawing_->erase(points, now);
    has_changed = true;
  }
  if (!has_changed) return true;
  if (!drawing_->clearErased()) return false;
  for (std::size_t i = 0; i < drawn_.size(); ++i) drawing_->redraw(pointsOf(scans_[i]), drawn_[i]);
  return true;
}

void GridRenderer::draw() const {
  if (!drawing_ || !redrawMoved()) {
    drawing_ = std::make_unique<GridDrawing>(config_, model_, base_);
    drawn_.clear();
  }
  while (drawn_.size() < scans_.size()) {
    const auto& next = scans_[drawn_.size()];
    drawing_->draw(pointsOf(next), next.pose);
    drawn_.push_back(next.pose);
  }
}

OccupancyGrid GridRenderer::grid() const {
  if (scans_.empty() && !base_) {
    OccupancyGrid nothing;
    nothing.resolution = model_.resolution();
    return nothing;
  }
  draw();
  return drawing_->grid();
}

double GridRenderer::reachOf(const LaserScan& scan) const {
  double reach = 0.0;
  forEachFan(scan, [&](const LaserFan& fan) {
    double furthest = 0.0;
    for (const auto& beam : fan.beams)
      furthest = std::max(furthest, static_cast<double>(beam.range));
    reach = std::max(reach,
                     std::min(furthest, config_.usable_range) + fan.sensor_pose.position().norm());
  });
  return reach;
}

void GridRenderer::cover(const Scan& scan) {
  covered_.extend(scan.pose.position() - Eigen::Vector2d::Constant(scan.reach));
  covered_.extend(scan.pose.position() + Eigen::Vector2d::Constant(scan.reach));
}

double GridRenderer::mostBytes() const {
  if (scans_.empty()) return 0.0;
  const double edge = config_.resolution * grid_map::Tile::kSize;
  const Eigen::Array2d tiles = covered_.sizes().array() / edge + 2.0;
  const double most = std::min(tiles.prod(), static_cast<double>(grid_map::mostTiles(config_)));
  return scan_bytes_ + most * sizeof(grid_map::Tile);
}

}  // namespace slam::graph_slam
