// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "incremental_solve.hpp"

#include <memory>

#include "cpu_time.hpp"
#include "slam_core/graph/factors.hpp"

namespace slam::eval {
namespace {

constexpr double kSigmaOfStart = 1e-4;  // [m, rad]

}  // namespace

IncrementalSolver::IncrementalSolver(const PoseGraph& graph, bool is_robust)
    : start_(graph.start), edges_(edgesByPose(graph)), is_robust_(is_robust) {}

Pose2 IncrementalSolver::placed() const {
  if (size_ == 0) return start_;
  const auto& edge = placingEdge(edges_[size_]);
  return edge.placed(optimizer_.pose(edge.older()));
}

std::shared_ptr<graph::Factor> IncrementalSolver::factorOf(const PoseEdge& edge) const {
  const Eigen::Matrix3d W = graph::weightOfInformation(edge.information);
  return std::make_shared<graph::Between>(edge.a, edge.b, edge.z, W);
}

void IncrementalSolver::step() {
  const auto newest = optimizer_.add(placed());
  if (size_ == 0) {
    const Eigen::Matrix3d W = Eigen::Matrix3d::Identity() / kSigmaOfStart;
    optimizer_.add(std::make_unique<graph::PosePrior>(newest, start_, W));
  }
  for (const auto& edge : edges_[size_])
    if (!is_robust_ || !edge.isLoop()) optimizer_.add(factorOf(edge));
  optimizer_.update({newest});
  if (is_robust_) addLoops();
  ++size_;
  const double begin = cpuMilliseconds();
  covariance_ = optimizer_.covariance({newest});
  marginal_ms_ += cpuMilliseconds() - begin;
}

void IncrementalSolver::addLoops() {
  const auto newest = static_cast<graph::Key>(size_);
  bool has_loops = false;
  for (const auto& edge : edges_[size_]) {
    if (!edge.isLoop()) continue;
    robust_.add(factorOf(edge));
    is_false_.push_back(edge.is_false ? 1 : 0);
    has_loops = true;
  }
  constexpr int kMostSteps = 10;
  if (!has_loops) return;
  robust_.judge([&] {
    for (int i = 0; i < kMostSteps && optimizer_.update({newest}); ++i) continue;
  });
}

IncrementalSolver::Loops IncrementalSolver::loops() const {
  Loops loops;
  for (std::size_t i = 0; i < is_false_.size(); ++i) {
    if (is_false_[i] != 0 && robust_.isBelieved(i)) ++loops.false_believed;
    if (is_false_[i] == 0 && !robust_.isBelieved(i)) ++loops.true_rejected;
  }
  return loops;
}

std::vector<Pose2> IncrementalSolver::poses() const {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < size_; ++i)
    poses.push_back(optimizer_.pose(static_cast<graph::Key>(i)));
  return poses;
}

IncrementalResult solveIncrementally(const PoseGraph& graph, bool is_robust,
                                     const std::function<void(std::size_t)>& report) {
  IncrementalSolver solver(graph, is_robust);
  IncrementalResult result;
  for (std::size_t i = 1; i <= graph.size(); ++i) {
    const double begin = cpuMilliseconds();
    solver.step();
    result.step_ms.push_back(cpuMilliseconds() - begin);
    if (report) report(i);
  }
  result.poses = solver.poses();
  result.loops = solver.loops();
  result.marginals_ms = solver.marginalMilliseconds();
  result.tree_mb = static_cast<double>(solver.optimizer().cost().bytes) * 1e-6;
  return result;
}

}  // namespace slam::eval
