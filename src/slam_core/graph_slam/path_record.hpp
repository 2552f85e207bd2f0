// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {

/// The poses of all steps, relative to the nodes before them, so that they follow the graph. It
/// grows by 40 bytes a step.
class PathRecord {
 public:
  /// The robot's pose now is one of the path.
  void add(Stamp stamp, const PathGraph& path);
  /// The poses of a node that is about to go now follow another one, or stay where they are in the
  /// map (-1).
  void hang(graph::Key node, graph::Key to, const graph::Optimizer& graph);
  std::vector<StampedPose> poses(const graph::Optimizer& graph) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(marks_, spans_);
  }

 private:
  friend struct SessionParts;  // writes and reads its members

  /// Relative to a node, or in the map where there is none (-1).
  struct Mark {
    Stamp stamp;
    graph::Key node;
    Pose2 pose;

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, node, pose);
    }
  };
  /// The marks of a node, and perhaps others between them.
  struct Span {
    std::size_t first, last;

    template <class Archive>
    void persist(Archive& archive) {
      archive(first, last);
    }
  };
  void push(const Mark& mark);

  std::vector<Mark> marks_;
  std::unordered_map<graph::Key, Span> spans_;  // looked up only, never iterated
};

}  // namespace slam::graph_slam
