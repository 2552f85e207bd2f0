// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_record.hpp"

#include <algorithm>

namespace slam::graph_slam {

void PathRecord::push(const Mark& mark) {
  marks_.push_back(mark);
  if (mark.node < 0) return;
  const auto last = marks_.size() - 1;
  spans_.try_emplace(mark.node, Span{last, last}).first->second.last = last;
}

void PathRecord::add(Stamp stamp, const PathGraph& path) {
  const auto& [node, motion, nodes] = path.tail();
  if (node)
    push({stamp, *node, motion ? motion->increment : Pose2()});
  else
    push({stamp, -1, path.robot().pose});
}

void PathRecord::hang(graph::Key node, graph::Key to, const graph::Optimizer& graph) {
  const auto found = spans_.find(node);
  if (found == spans_.end()) return;
  const auto span = found->second;
  const Pose2 T_to_node = to < 0 ? graph.pose(node) : graph.pose(to).between(graph.pose(node));
  for (auto i = span.first; i <= span.last; ++i) {
    auto& mark = marks_[i];
    if (mark.node == node) mark = {mark.stamp, to, T_to_node * mark.pose};
  }
  spans_.erase(found);
  if (to < 0) return;
  auto& of_both = spans_.try_emplace(to, span).first->second;
  of_both = {std::min(of_both.first, span.first), std::max(of_both.last, span.last)};
}

std::vector<StampedPose> PathRecord::poses(const graph::Optimizer& graph) const {
  std::vector<StampedPose> poses;
  poses.reserve(marks_.size());
  for (const auto& [stamp, node, pose] : marks_)
    poses.push_back({stamp, node < 0 ? pose : graph.pose(node) * pose});
  return poses;
}

}  // namespace slam::graph_slam
