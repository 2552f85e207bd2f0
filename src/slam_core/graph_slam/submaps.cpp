// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/submaps.hpp"

#include <utility>

namespace slam::graph_slam {

Submaps::Submaps(const grid_map::GridMapConfig& config, double way) : config_(config), way_(way) {
  older_.map = std::make_unique<scan_matching::ScanMap>(config_);
}

void Submaps::insert(const scan_matching::ScanLevels& scan, graph::Key node, const Pose2& pose) {
  if (!older_.places.empty()) gone_ += (pose.position() - last_.position()).norm();
  last_ = pose;
  if (gone_ - renewed_ >= way_) {
    if (younger_.map) {
      finished_.push_back(std::move(older_));
      older_ = std::move(younger_);
    }
    younger_ = {};
    younger_.map = std::make_unique<scan_matching::ScanMap>(config_);
    renewed_ = gone_;
  }
  add(scan, node, pose, older_);
  if (younger_.map) add(scan, node, pose, younger_);
}

void Submaps::add(const scan_matching::ScanLevels& scan, graph::Key node, const Pose2& pose,
                  Submap& submap) const {
  if (submap.origin < 0) {
    submap.origin = node;
    submap.T_odom_origin = pose;
  }
  submap.map->insert(scan, pose);
  submap.places.push_back(pose);
  submap.ended = gone_;
}

double Submaps::bytes() const {
  double sum = 0.0;
  for (const auto& submap : finished_) sum += static_cast<double>(submap.map->bytes());
  for (const auto* submap : {&older_, &younger_})
    if (submap->map) sum += static_cast<double>(submap->map->bytes());
  return sum;
}

}  // namespace slam::graph_slam
