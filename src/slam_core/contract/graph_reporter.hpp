// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/common/choice.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// An edge of the graph: a line in the map frame between the two things that a measurement joins.
struct GraphEdge {
  enum class Kind {
    kMotion,      ///< from one pose to the next one
    kSighting,    ///< from a pose to a landmark that was seen from there
    kLoop,        ///< from a pose to a place that was recognised
    kWaitingLoop  ///< the same, if it is not believed (yet)
  };

  Kind kind = Kind::kMotion;
  Eigen::Vector2d from, to;  ///< [m]
  double weight = 1.0;       ///< robust weight, in [0, 1]
};

/// The kinds of edges have these names in files.
inline const Names<GraphEdge::Kind>& namesOfEdges() {
  static const Names<GraphEdge::Kind> names = {{"motion", GraphEdge::Kind::kMotion},
                                               {"sighting", GraphEdge::Kind::kSighting},
                                               {"loop", GraphEdge::Kind::kLoop},
                                               {"waiting_loop", GraphEdge::Kind::kWaitingLoop}};
  return names;
}

/// A pose graph to be shown, in the map frame.
struct GraphView {
  std::vector<Pose2> nodes;    ///< poses of the robot, the oldest first
  std::vector<Pose2> submaps;  ///< poses to which local maps are attached
  std::vector<GraphEdge> edges;
};

/// The capability of a back-end whose estimate is a graph of poses.
class GraphReporter {
 public:
  virtual ~GraphReporter() = default;
  /// The graph as it is estimated now. The time that it takes grows with the size of the graph.
  virtual GraphView graph() const = 0;
};

}  // namespace slam
