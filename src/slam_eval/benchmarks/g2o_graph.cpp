// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "g2o_graph.hpp"

#include <filesystem>

#include "g2o_records.hpp"
#include "import_error.hpp"

namespace slam::eval {
namespace {

G2oRecords readRecords(const std::string& path) {
  const auto rows = readRows(path, '#');
  G2oRecords records;
  try {
    for (const auto& row : rows) records.take(row);
  } catch (const ImportError& error) {
    throw ImportError(std::string(error.what()) + "; correct this line or write the file anew");
  }
  if (records.vertices().empty() || records.edges().empty())
    throw ImportError(path + ": there is no " +
                      (records.vertices().empty() ? "VERTEX_SE2" : "EDGE_SE2") +
                      "; give a graph of poses in the plane");
  return records;
}

}  // namespace

PoseGraph readG2o(const std::string& path) {
  const auto records = readRecords(path);
  PoseGraph graph;
  graph.name = std::filesystem::path(path).stem().string();
  graph.ids = records.order();
  graph.start = records.vertices().at(graph.ids.front()).pose;
  graph.left_out = records.leftOut();
  std::map<std::int64_t, int> number;
  for (const auto id : graph.ids) number.emplace(id, static_cast<int>(number.size()));
  for (const auto& edge : records.edges())
    graph.edges.push_back({number.at(edge.a), number.at(edge.b), edge.z, edge.information});
  return graph;
}

}  // namespace slam::eval
