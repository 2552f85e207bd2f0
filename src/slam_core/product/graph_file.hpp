// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/graph_reporter.hpp"

namespace slam {

/// A graph as a table, "kind,x0,y0,x1,y1,weight", map frame [m]: a line for each node and submap,
/// which have one place, and for each edge.
std::string graphTable(const GraphView& graph);

}  // namespace slam
