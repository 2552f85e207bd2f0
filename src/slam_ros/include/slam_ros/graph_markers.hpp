// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "slam_core/contract/graph_reporter.hpp"

namespace slam_ros {

/// Of a larger graph only every n-th node or edge of a kind is drawn, so that there are at most so
/// many.
constexpr std::size_t kMostDrawn = 20000;

/// Draws a graph of any size with one marker for each kind of node and edge. Motion is grey,
/// sightings of landmarks are thin and blue, loops are green, the more orange the smaller their
/// weight, and waiting loops are red. Nodes are points, and the origins of submaps are larger
/// points. The marker of a kind that the graph does not have is deleted.
visualization_msgs::MarkerArray toMarkers(const slam::GraphView& graph,
                                          const std_msgs::Header& header);

}  // namespace slam_ros
