// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "slam_core/contract/graph_reporter.hpp"

namespace slam_ros {

/// Of a larger graph every n-th node or edge of a kind is drawn, so that no more are left.
constexpr std::size_t kMostDrawn = 20000;

/// A graph as one marker for each kind of node and edge, however large it is: motion grey,
/// sightings of landmarks thin and blue, loops green, those that count less the more orange, those
/// that wait red; nodes as points and the origins of submaps as larger ones. A kind that the graph
/// has not is deleted.
visualization_msgs::MarkerArray toMarkers(const slam::GraphView& graph,
                                          const std_msgs::Header& header);

}  // namespace slam_ros
