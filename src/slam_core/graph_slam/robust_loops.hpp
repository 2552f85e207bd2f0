// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/graph/optimizer.hpp"

namespace slam::graph_slam {

/// Loop closures of which each counts as much as the graph bears it out: dynamic covariance scaling
/// (Agarwal, Tipaldi, Spinello, Stachniss, Burgard 2013). A false one ends up with nearly no
/// weight, and gets it back when the graph comes to agree with it.
class RobustLoops {
 public:
  void add(graph::FactorId loop) { loops_.push_back({loop, 1.0}); }
  /// Weighs all loops at the estimate. @return whether a weight has changed much
  bool weigh(graph::Optimizer& graph);
  std::size_t size() const { return loops_.size(); }
  /// Loops that hardly count.
  std::size_t rejected() const;

 private:
  struct Loop {
    graph::FactorId factor;
    double weight;
  };
  std::vector<Loop> loops_;
};

}  // namespace slam::graph_slam
