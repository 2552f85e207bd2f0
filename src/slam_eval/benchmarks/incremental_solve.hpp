// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "pose_graph.hpp"
#include "slam_core/graph/robust_loops.hpp"

namespace slam::eval {

/// Solves a graph as it grows: step() for one pose after the other.
class IncrementalSolver {
 public:
  /// @param is_robust any loop may be false
  IncrementalSolver(const PoseGraph& graph, bool is_robust);

  /// Adds the next pose and its edges to earlier ones, solves, and computes the covariance of the
  /// pose.
  void step();

  graph::Optimizer& optimizer() { return optimizer_; }
  std::vector<Pose2> poses() const;
  /// The covariance describes a correction of the newest pose (slam::graph::Variables).
  const Eigen::Matrix3d& covariance() const { return covariance_; }
  /// Loops by what became of them; all are believed where the solver is not robust.
  struct Loops {
    int true_rejected = 0, false_believed = 0;
  };
  Loops loops() const;
  double marginalMilliseconds() const { return marginal_ms_; }  ///< CPU time of the covariances

 private:
  Pose2 placed() const;
  std::shared_ptr<graph::Factor> factorOf(const PoseEdge& edge) const;
  void addLoops();

  Pose2 start_;
  std::vector<std::vector<PoseEdge>> edges_;
  bool is_robust_;
  graph::Optimizer optimizer_;
  graph::RobustLoops robust_{optimizer_, graph::RobustLoops::Noise::kLearnt};
  std::vector<char> is_false_;  ///< by loop of robust_
  std::size_t size_ = 0;        ///< poses so far
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  double marginal_ms_ = 0.0;
};

/// What solving a graph at every pose has given and cost.
struct IncrementalResult {
  std::vector<Pose2> poses;
  std::vector<double> step_ms;  ///< CPU time of each step
  double marginals_ms = 0.0;    ///< of the covariances alone, in all steps
  double tree_mb = 0.0;         ///< the numbers in the Bayes tree at the end
  IncrementalSolver::Loops loops;
};

/// @param report is called after each step with the number of steps so far
IncrementalResult solveIncrementally(const PoseGraph& graph, bool is_robust,
                                     const std::function<void(std::size_t)>& report = {});

}  // namespace slam::eval
