// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/local_scans.hpp"

#include <set>
#include <utility>

#include "slam_core/grid_map/beam_reading.hpp"

namespace slam::relocalisation {
namespace {

using scan_matching::ScanLevels;

constexpr double kInsertDistance = 0.3, kInsertAngle = 0.3;  // [m], [rad]

/// Adds the first end in each cell.
/// @param taken the cells that have one already
void addEnds(const grid_map::ScanPoints& points, const Pose2& pose,
             std::set<std::pair<int, int>>& taken, std::vector<Eigen::Vector2d>& ends) {
  const Pose2 in_cells = points.inCells(pose);
  for (const auto& end : points.ends) {
    const Eigen::Vector2d moved = in_cells.transform(end);
    const auto cell = grid_map::cellOf(moved);
    if (taken.emplace(cell.x, cell.y).second) ends.push_back(moved);
  }
}

}  // namespace

LocalScans::LocalScans(const grid_map::GridMapConfig& grid,
                       const scan_matching::MatcherConfig& matcher, double way)
    : config_(grid),
      way_(way),
      spacing_(matcher.spacing),
      models_(scan_matching::levelModels(config_)),
      tracker_(matcher),
      trigger_(kInsertDistance, kInsertAngle) {
  forget();
}

void LocalScans::forget() {
  map_ = std::make_unique<scan_matching::ScanMap>(config_);
  drawn_ = 0;
  tracker_.restart({});
  trigger_.restart();
  kept_.clear();
  carried_.reset();
  gone_ = 0.0;
}

void LocalScans::move(const Motion& motion) {
  carried_ = carried_ ? joined(*carried_, motion) : motion;
}

bool LocalScans::take(const LaserScan& scan) {
  const auto points = scan_matching::pointsOf(scan, models_, spacing_);
  const auto motion = std::exchange(carried_, std::nullopt);
  const auto before = robot();
  const auto found = tracker_.track(map_->view(), points, scan.stamp, motion);
  has_begun_anew_ = found.is_anywhere;
  if (has_begun_anew_)
    forget();
  else
    gone_ += (robot().position() - before.position()).norm();
  const bool is_kept = !points[0].ends.empty() && (kept_.empty() || trigger_.isDue(robot()));
  if (is_kept) keep(points);
  return is_kept;
}

void LocalScans::keep(const ScanLevels& points) {
  trigger_.note(robot());
  kept_.push_back({points, robot(), gone_});
  while (gone_ - kept_.front().gone > way_) kept_.pop_front();
  constexpr std::size_t kMostStale = 4;  // times as many scans as are kept
  if (drawn_ > kMostStale * kept_.size()) redraw();
  map_->insert(points, robot());
  ++drawn_;
}

/// Draws the map anew of all scans that are kept but the last one, which keep() inserts.
void LocalScans::redraw() {
  map_ = std::make_unique<scan_matching::ScanMap>(config_);
  for (const auto& kept : kept_)
    if (&kept != &kept_.back()) map_->insert(kept.points, kept.pose);
  drawn_ = kept_.size() - 1;
}

ScanLevels LocalScans::together() const {
  ScanLevels all = kept_.back().points;
  for (std::size_t level = 0; level < all.size(); ++level) {
    all[level].beams.clear();
    all[level].ends.clear();
    all[level].fans.resize(1);
    std::set<std::pair<int, int>> taken;
    for (const auto& kept : kept_)
      addEnds(kept.points[level], robot().between(kept.pose), taken, all[level].ends);
  }
  return all;
}

}  // namespace slam::relocalisation
