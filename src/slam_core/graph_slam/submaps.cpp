// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/submaps.hpp"

#include <algorithm>
#include <utility>

namespace slam::graph_slam {
namespace {

/// Of the drawings of finished submaps [B].
constexpr std::size_t kMostDrawn = 64'000'000;

}  // namespace

Submaps::Submaps(const grid_map::GridMapConfig& config, double way)
    : config_(config), way_(way), older_(config) {}

void Submaps::insert(const SharedScan& scan, const scan_matching::ScanLevels& points,
                     graph::Key node, const Pose2& pose) {
  if (!older_.isEmpty()) gone_ += (pose.position() - last_.position()).norm();
  last_ = pose;
  if (gone_ - renewed_ >= way_) renew();
  older_.insert(scan, points, node, pose);
  if (younger_) younger_->insert(scan, points, node, pose);
}

void Submaps::renew() {
  if (younger_) {
    finished_.push_back({std::move(older_), gone_, ++uses_});
    older_ = std::move(*younger_);
  }
  younger_.emplace(config_);
  renewed_ = gone_;
  giveUpDrawings(finished_.size());
}

scan_matching::MapView Submaps::view(std::size_t number) {
  auto& wanted = finished_[number];
  wanted.used = ++uses_;
  const auto view = wanted.submap.map().view();
  giveUpDrawings(number);
  return view;
}

/// Of those that were not used for the longest time.
void Submaps::giveUpDrawings(std::size_t kept) {
  std::size_t drawn = 0;
  for (const auto& each : finished_) drawn += each.submap.bytes();
  while (drawn > kMostDrawn) {
    Finished* oldest = nullptr;
    for (std::size_t i = 0; i < finished_.size(); ++i) {
      auto& each = finished_[i];
      const bool may_go = i != kept && each.submap.bytes() > 0 && !each.submap.isLoaded();
      if (may_go && (oldest == nullptr || each.used < oldest->used)) oldest = &each;
    }
    if (oldest == nullptr) return;
    drawn -= oldest->submap.bytes();
    oldest->submap.giveUpDrawing();
  }
}

bool Submaps::isInHand(graph::Key node) const {
  const auto holds = [node](const Submap& submap) {
    return std::find(submap.nodes().begin(), submap.nodes().end(), node) != submap.nodes().end();
  };
  return holds(older_) || (younger_ && holds(*younger_));
}

std::size_t Submaps::bytes() const {
  std::size_t sum = older_.bytes() + (younger_ ? younger_->bytes() : 0);
  for (const auto& each : finished_) sum += each.submap.bytes();
  return sum;
}

}  // namespace slam::graph_slam
