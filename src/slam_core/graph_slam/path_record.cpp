// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_record.hpp"

namespace slam::graph_slam {

void PathRecord::add(Stamp stamp, const PathGraph& path) {
  const auto& [node, motion, nodes] = path.tail();
  if (node)
    marks_.push_back({stamp, *node, motion ? motion->increment : Pose2()});
  else
    marks_.push_back({stamp, -1, path.robot().pose});
}

std::vector<StampedPose> PathRecord::poses(const graph::Optimizer& graph) const {
  std::vector<StampedPose> poses;
  poses.reserve(marks_.size());
  for (const auto& [stamp, node, pose] : marks_)
    poses.push_back({stamp, node < 0 ? pose : graph.pose(node) * pose});
  return poses;
}

}  // namespace slam::graph_slam
