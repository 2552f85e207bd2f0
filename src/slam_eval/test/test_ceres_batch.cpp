// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "ceres_batch.hpp"
#include "graph_world.hpp"
#include "incremental_solve.hpp"
#include "trajectory_error.hpp"

namespace slam::eval {
namespace {

PoseGraph cityOf(int poses, std::uint64_t seed) {
  GraphWorldConfig config;
  config.poses = poses;
  return makeGraphWorld(config, seed);
}

double largestDifference(const std::vector<Pose2>& some, const std::vector<Pose2>& others) {
  double largest = 0.0;
  for (std::size_t i = 0; i < some.size(); ++i)
    largest = std::max(largest, some[i].between(others[i]).vector().norm());
  return largest;
}

TEST(CeresBatch, FindsTheSameMinimumAsTheOptimizer) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto graph = cityOf(300, seed);
    IncrementalSolver solver(graph, false);
    for (std::size_t i = 0; i < graph.size(); ++i) solver.step();
    ASSERT_TRUE(solver.optimizer().optimize({299}, 20));
    const auto batch = solveByCeres(graph, deadReckoning(graph));
    ASSERT_TRUE(batch.has_converged);
    EXPECT_NEAR(chi2(graph, solver.poses()), batch.chi2, 1e-6 * batch.chi2);
    EXPECT_NEAR(solver.optimizer().chi2(), batch.chi2, 1e-6 * batch.chi2);
    EXPECT_LT(largestDifference(solver.poses(), batch.poses), 2e-3);
  }
}

TEST(CeresBatch, LeavesTheFirstPoseWhereItIs) {
  auto graph = cityOf(100, 1);
  graph.start = Pose2(5, -3, 2);
  const auto batch = solveByCeres(graph, deadReckoning(graph));
  EXPECT_EQ(batch.poses.front().vector(), graph.start.vector());
  EXPECT_LT(positionError(batch.poses, graph.truth), 0.2);
}

TEST(CeresBatch, TakesTheSmallWayAroundTheCircle) {
  PoseGraph graph;
  graph.ids = {0, 1, 2};
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  graph.edges = {{0, 1, Pose2(1, 0, 3.1), one},
                 {1, 2, Pose2(1, 0, 3.1), one},
                 {0, 2, Pose2(1, 0, 3.1).compose(Pose2(1, 0, 3.1)), one}};
  const auto start = deadReckoning(graph);
  ASSERT_LT(start[2].theta() - start[1].theta(), -M_PI);  // the heading passes pi
  const auto batch = solveByCeres(graph, start);
  EXPECT_LT(batch.chi2, 1e-12);
  EXPECT_LT(largestDifference(batch.poses, start), 1e-9);
}

TEST(IncrementalSolve, ComesToTheMinimumOfTheBatchOnItsWay) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const auto graph = cityOf(400, seed);
    std::size_t last = 0;
    const auto steps = solveIncrementally(graph, false, [&last](std::size_t done) { last = done; });
    EXPECT_EQ(last, graph.size());
    EXPECT_EQ(steps.step_ms.size(), graph.size());
    const auto batch = solveByCeres(graph, deadReckoning(graph));
    const double ratio = chi2(graph, steps.poses) / batch.chi2;
    EXPECT_GT(ratio, 1.0 - 1e-6);
    EXPECT_LT(ratio, 1.001);
    const double error = positionError(steps.poses, graph.truth);
    EXPECT_LT(error, 0.5 * positionError(deadReckoning(graph), graph.truth));
  }
}

TEST(IncrementalSolve, TellsHowSureTheNewestPoseIs) {
  const auto graph = cityOf(50, 1);
  IncrementalSolver solver(graph, false);
  solver.step();
  const double at_start = solver.covariance().trace();
  for (int i = 1; i < 15; ++i) solver.step();
  const Eigen::Matrix3d covariance = solver.covariance();
  EXPECT_GT(covariance.trace(), 10.0 * at_start);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().minCoeff(),
            0.0);
}

TEST(IncrementalSolve, TakesEdgesAgainstTheWay) {
  auto graph = cityOf(200, 2);
  const auto expected = solveIncrementally(graph, false).poses;
  for (auto& edge : graph.edges) {
    if (edge.a % 2 == 0) continue;
    std::swap(edge.a, edge.b);
    edge.z = edge.z.inverse();
  }
  // the same ways measured from the other end: another weighting of the same noise
  EXPECT_LT(positionError(solveIncrementally(graph, false).poses, expected), 0.05);
}

}  // namespace
}  // namespace slam::eval
