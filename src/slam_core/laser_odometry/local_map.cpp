// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/local_map.hpp"

#include <utility>

namespace slam::laser_odometry {

using scan_matching::ScanMap;

LocalMap::LocalMap(const grid_map::GridMapConfig& config, double way)
    : config_(config), way_(way), older_(empty()) {}

std::unique_ptr<ScanMap> LocalMap::empty() const { return std::make_unique<ScanMap>(config_); }

void LocalMap::reset() {
  older_ = empty();
  younger_.reset();
  gone_ = 0.0;
}

void LocalMap::insert(const scan_matching::ScanLevels& scan, const Pose2& pose) {
  if (!older_->isEmpty()) gone_ += (pose.position() - last_.position()).norm();
  last_ = pose;
  if (gone_ >= way_) {
    if (younger_) older_ = std::move(younger_);
    younger_ = empty();
    gone_ = 0.0;
  }
  older_->insert(scan, pose);
  if (younger_) younger_->insert(scan, pose);
}

std::size_t LocalMap::bytes() const { return older_->bytes() + (younger_ ? younger_->bytes() : 0); }

}  // namespace slam::laser_odometry
