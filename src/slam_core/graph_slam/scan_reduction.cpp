// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_reduction.hpp"

#include <algorithm>
#include <cmath>

namespace slam::graph_slam {
namespace {

/// A scan from so near another one shows much of what that one shows [m, rad].
constexpr double kNear = 1.0, kTurned = M_PI / 4;
/// Near so many scans that stay, one more shows nothing new: about those of three passes.
constexpr int kEnough = 15;

bool has(const std::vector<graph::Key>& nodes, graph::Key node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

}  // namespace

void ScanReduction::reduce() {
  if (submaps_.finished().size() == finished_) return;
  const auto& last = submaps_.finished().back().submap;
  if (isKnown(last) && hasLoop(last) && hasLoop(submaps_.current())) {
    drop();
    return;
  }
  keep(last);
}

void ScanReduction::keepAll() {
  for (const auto& finished : submaps_.finished()) keep(finished.submap);
}

void ScanReduction::keep(const Submap& submap) {
  finished_ = submaps_.finished().size();
  for (const auto node : submap.nodes())
    if (!has(kept_, node)) kept_.push_back(node);
}

bool ScanReduction::isKnown(const Submap& submap) const {
  const auto& nodes = submap.nodes();
  return !submap.isLoaded() &&
         std::all_of(nodes.begin(), nodes.end(), [this](auto node) { return isNearKept(node); });
}

bool ScanReduction::isNearKept(graph::Key node) const {
  const Pose2 pose = path_.graph().pose(node);
  const auto count = std::count_if(kept_.begin(), kept_.end(), [&](graph::Key other) {
    const Pose2 between = pose.between(path_.graph().pose(other));
    return between.position().norm() <= kNear && std::abs(between.theta()) <= kTurned;
  });
  return count >= kEnough;
}

bool ScanReduction::hasLoop(const Submap& submap) const {
  const auto& nodes = submap.nodes();
  return std::any_of(nodes.begin(), nodes.end(),
                     [this](auto node) { return loops_.believesOneOf(node); });
}

void ScanReduction::drop() {
  const auto nodes = submaps_.finished().back().submap.nodes();
  submaps_.dropLast();
  for (const auto node : nodes) {
    if (has(kept_, node) || submaps_.isInHand(node)) continue;
    loops_.forget(node);
    renderer_.remove(node);
    released_.push_back(node);
  }
}

bool ScanReduction::holds(graph::Key node) const {
  return has(kept_, node) || submaps_.isInHand(node);
}

}  // namespace slam::graph_slam
