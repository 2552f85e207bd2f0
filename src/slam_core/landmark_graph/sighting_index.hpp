// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "slam_core/graph/quadratic_factor.hpp"

namespace slam::landmark_graph {

/// Which factors tell of which landmark, from which node.
class SightingIndex {
 public:
  void addLandmark() { of_landmark_.emplace_back(); }
  /// A factor that holds a landmark without a node, such as a prior of a loaded map.
  void addPrior(std::size_t landmark, graph::FactorId factor) {
    of_landmark_[landmark].push_back({-1, factor});
  }
  void add(std::size_t landmark, graph::Key node, graph::FactorId factor);
  /// @return the factor of that node that observed the landmark
  graph::FactorId remove(std::size_t landmark, graph::Key node);
  /// @return the factors that observed the landmark
  std::vector<graph::FactorId> removeLandmark(std::size_t landmark);
  /// @return the factors of the node
  std::vector<graph::FactorId> removeNode(graph::Key node);

  /// The factor of a node that tells of the landmark; there must be one.
  graph::FactorId factor(std::size_t landmark, graph::Key node) const;
  /// @return the number of factors that tell of a landmark
  std::size_t count(std::size_t landmark) const { return of_landmark_[landmark].size(); }
  /// @return the node of each of these factors; -1 for one without a node
  std::vector<graph::Key> nodesThatSaw(std::size_t landmark) const;
  /// The landmarks that were seen from a node.
  const std::vector<std::size_t>& seenFrom(graph::Key node) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(of_landmark_, of_node_);
  }

 private:
  struct Sighting {
    graph::Key node;
    graph::FactorId factor;

    template <class Archive>
    void persist(Archive& archive) {
      archive(node, factor);
    }
  };
  std::vector<std::vector<Sighting>> of_landmark_;
  std::unordered_map<graph::Key, std::vector<std::size_t>> of_node_;  // looked up only
};

}  // namespace slam::landmark_graph
