// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/graph_slam/scan_graph.hpp"

namespace slam::graph_slam {

/// The graph as it is to be seen: what its factors join. A factor that joins neither two poses nor
/// a pose and a point shows its poses alone.
/// @param scans null where there are none
GraphView viewOf(const graph::Optimizer& graph, const ScanGraph* scans);

}  // namespace slam::graph_slam
