// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "text_table.hpp"

namespace slam::eval {

/// The records of a g2o file, checked one by one.
class G2oRecords {
 public:
  struct Vertex {
    Pose2 pose;
    std::string place;  ///< file and line
  };
  struct Edge {
    std::int64_t a = 0, b = 0;
    Pose2 z;
    Eigen::Matrix3d information;
    std::string place;
  };

  /// @throw ImportError where the row is not what its type says
  void take(const TextRow& row);

  /// Ids in the order in which a robot came there: the lowest one first, then always the lowest one
  /// that an edge joins to one before.
  /// @throw ImportError where an edge names no vertex, or no edges lead to a vertex
  std::vector<std::int64_t> order() const;

  const std::map<std::int64_t, Vertex>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Counts the records of other types, by type.
  const std::map<std::string, int>& leftOut() const { return left_out_; }

 private:
  using Neighbours = std::map<std::int64_t, std::set<std::int64_t>>;
  void takeVertex(const TextRow& row);
  void takeEdge(const TextRow& row);
  Neighbours neighbours() const;
  void requireAll(const std::set<std::int64_t>& found) const;

  std::map<std::int64_t, Vertex> vertices_;
  std::vector<Edge> edges_;
  std::map<std::string, int> left_out_;
};

}  // namespace slam::eval
