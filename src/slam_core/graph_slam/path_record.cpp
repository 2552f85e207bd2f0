// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_record.hpp"

namespace slam::graph_slam {

void PathRecord::add(Stamp stamp, const PathGraph& path) {
  const auto& [node, motion, nodes] = path.tail();
  if (!node) {
    marks_.push_back({stamp, -1, path.robot().pose});
    return;
  }
  marks_.push_back({stamp, *node, motion ? motion->increment : Pose2()});
  const auto last = marks_.size() - 1;
  spans_.try_emplace(*node, Span{last, last}).first->second.last = last;
}

void PathRecord::hang(graph::Key node, graph::Key to, const graph::Optimizer& graph) {
  const auto span = spans_.find(node);
  if (span == spans_.end()) return;
  const Pose2 T_to_node = to < 0 ? graph.pose(node) : graph.pose(to).between(graph.pose(node));
  for (auto i = span->second.first; i <= span->second.last; ++i) {
    auto& mark = marks_[i];
    if (mark.node == node) mark = {mark.stamp, to, T_to_node * mark.pose};
  }
  spans_.erase(span);
}

std::vector<StampedPose> PathRecord::poses(const graph::Optimizer& graph) const {
  std::vector<StampedPose> poses;
  poses.reserve(marks_.size());
  for (const auto& [stamp, node, pose] : marks_)
    poses.push_back({stamp, node < 0 ? pose : graph.pose(node) * pose});
  return poses;
}

}  // namespace slam::graph_slam
