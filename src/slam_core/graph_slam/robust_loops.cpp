// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/robust_loops.hpp"

#include <algorithm>
#include <cmath>

namespace slam::graph_slam {
namespace {

/// Up to this squared Mahalanobis distance a loop counts in full: nine of ten right ones.
constexpr double kUsual = 6.25;
constexpr double kChange = 0.05, kRejected = 0.1;

/// That of the scaled covariance: s^2 with s = 2 kUsual / (kUsual + chi2).
double weightOf(double chi2) {
  const double s = std::min(1.0, 2.0 * kUsual / (kUsual + chi2));
  return s * s;
}

}  // namespace

bool RobustLoops::weigh(graph::Optimizer& graph) {
  bool has_changed = false;
  for (auto& [factor, weight] : loops_) {
    const double next = weightOf(graph.chi2(factor));
    if (std::abs(next - weight) <= kChange) continue;
    weight = next;
    graph.setWeight(factor, weight);
    has_changed = true;
  }
  return has_changed;
}

std::size_t RobustLoops::rejected() const {
  return static_cast<std::size_t>(std::count_if(
      loops_.begin(), loops_.end(), [](const Loop& loop) { return loop.weight < kRejected; }));
}

}  // namespace slam::graph_slam
