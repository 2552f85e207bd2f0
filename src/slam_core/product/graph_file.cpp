// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/graph_file.hpp"

#include <fmt/format.h>

namespace slam {
namespace {

std::string graphLine(const std::string& kind, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to, double weight) {
  // adding zero turns -0 into 0
  return fmt::format("{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", kind, from.x() + 0.0,
                     from.y() + 0.0, to.x() + 0.0, to.y() + 0.0, weight);
}

}  // namespace

std::string graphTable(const GraphView& graph) {
  std::string table = "kind,x0,y0,x1,y1,weight\n";
  for (const auto& node : graph.nodes)
    table += graphLine("node", node.position(), node.position(), 1.0);
  for (const auto& submap : graph.submaps)
    table += graphLine("submap", submap.position(), submap.position(), 1.0);
  for (const auto& edge : graph.edges)
    table += graphLine(nameOf(edge.kind, namesOfEdges()), edge.from, edge.to, edge.weight);
  return table;
}

}  // namespace slam
