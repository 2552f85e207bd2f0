// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "g2o_records.hpp"

#include <Eigen/Cholesky>

#include "import_error.hpp"

namespace slam::eval {
namespace {

void requireFields(const TextRow& row, std::size_t fields) {
  if (row.size() == fields) return;
  throw ImportError(row.place() + ": " + row.text(0) + " has " + std::to_string(row.size() - 1) +
                    " values instead of " + std::to_string(fields - 1) +
                    ", as if the line was cut");
}

Pose2 poseAt(const TextRow& row, std::size_t column) {
  return {row.number(column), row.number(column + 1), row.number(column + 2)};
}

Eigen::Matrix3d informationAt(const TextRow& row, std::size_t column) {
  Eigen::Matrix3d information;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) information(i, j) = information(j, i) = row.number(column++);
  if (Eigen::LLT<Eigen::Matrix3d>(information).info() != Eigen::Success)
    throw ImportError(row.place() + ": the information matrix is not positive definite");
  return information;
}

}  // namespace

void G2oRecords::take(const TextRow& row) {
  if (row.text(0) == "VERTEX_SE2")
    takeVertex(row);
  else if (row.text(0) == "EDGE_SE2")
    takeEdge(row);
  else
    ++left_out_[row.text(0)];
}

void G2oRecords::takeVertex(const TextRow& row) {
  requireFields(row, 5);
  const auto id = row.integer(1);
  const auto [vertex, is_new] = vertices_.insert({id, {poseAt(row, 2), row.place()}});
  if (!is_new)
    throw ImportError(row.place() + ": the vertex " + std::to_string(id) + " stands already in " +
                      vertex->second.place);
}

void G2oRecords::takeEdge(const TextRow& row) {
  requireFields(row, 12);
  const Edge edge{row.integer(1), row.integer(2), poseAt(row, 3), informationAt(row, 6),
                  row.place()};
  if (edge.a == edge.b)
    throw ImportError(row.place() + ": the edge joins the vertex " + std::to_string(edge.a) +
                      " to itself");
  edges_.push_back(edge);
}

G2oRecords::Neighbours G2oRecords::neighbours() const {
  Neighbours neighbours;
  for (const auto& edge : edges_) {
    for (const auto id : {edge.a, edge.b})
      if (vertices_.count(id) == 0)
        throw ImportError(edge.place + ": the edge joins the vertex " + std::to_string(id) +
                          ", which has no VERTEX_SE2; add its line, or remove the edge");
    neighbours[edge.a].insert(edge.b);
    neighbours[edge.b].insert(edge.a);
  }
  return neighbours;
}

void G2oRecords::requireAll(const std::set<std::int64_t>& found) const {
  if (found.size() == vertices_.size()) return;
  for (const auto& [id, vertex] : vertices_) {
    if (found.count(id) != 0) continue;
    throw ImportError(vertex.place + ": no edge joins the vertex " + std::to_string(id) +
                      " to the vertex " + std::to_string(vertices_.begin()->first) +
                      ", not by way of others either (this holds for " +
                      std::to_string(vertices_.size() - found.size()) + " of " +
                      std::to_string(vertices_.size()) +
                      " vertices); add the missing edges, or remove the vertices");
  }
}

std::vector<std::int64_t> G2oRecords::order() const {
  const auto neighbours = this->neighbours();
  std::vector<std::int64_t> order;
  std::set<std::int64_t> found, next;
  if (!vertices_.empty()) found.insert(vertices_.begin()->first);
  for (next = found; !next.empty();) {
    const auto id = *next.begin();
    next.erase(next.begin());
    order.push_back(id);
    const auto joined = neighbours.find(id);
    if (joined == neighbours.end()) continue;
    for (const auto neighbour : joined->second)
      if (found.insert(neighbour).second) next.insert(neighbour);
  }
  requireAll(found);
  return order;
}

}  // namespace slam::eval
