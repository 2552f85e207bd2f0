// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/graph_slam/path_graph.hpp"

namespace slam::graph_slam {

/// The poses of all steps, told by the nodes before them, so that they follow the graph.
class PathRecord {
 public:
  /// The robot's pose now is one of the path.
  void add(Stamp stamp, const PathGraph& path);
  std::vector<StampedPose> poses(const graph::Optimizer& graph) const;

 private:
  friend struct SessionParts;  // writes and reads its members

  /// Relative to a node, or in the map where there is none (-1).
  struct Mark {
    Stamp stamp;
    graph::Key node;
    Pose2 pose;
  };
  std::vector<Mark> marks_;
};

}  // namespace slam::graph_slam
