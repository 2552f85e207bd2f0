// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "graph_world.hpp"
#include "trajectory_error.hpp"

namespace slam::eval {
namespace {

GraphWorldConfig smallCity() {
  GraphWorldConfig config;
  config.poses = 600;
  return config;
}

/// The errors of all edges at the truth, in units of their sigmas.
std::vector<Eigen::Vector3d> whitenedErrors(const PoseGraph& graph) {
  std::vector<Eigen::Vector3d> errors;
  for (const auto& edge : graph.edges) {
    const auto e = edge.error(graph.truth[static_cast<std::size_t>(edge.a)],
                              graph.truth[static_cast<std::size_t>(edge.b)]);
    errors.push_back(edge.information.diagonal().cwiseSqrt().cwiseProduct(e.vector()));
  }
  return errors;
}

TEST(GraphWorld, IsTheSameForOneSeedAndAnotherForOthers) {
  const auto one = makeGraphWorld(smallCity(), 1), again = makeGraphWorld(smallCity(), 1);
  const auto other = makeGraphWorld(smallCity(), 2);
  ASSERT_EQ(one.edges.size(), again.edges.size());
  for (std::size_t i = 0; i < one.edges.size(); ++i) {
    EXPECT_EQ(one.edges[i].z.vector(), again.edges[i].z.vector());
    EXPECT_EQ(one.edges[i].a, again.edges[i].a);
  }
  EXPECT_NE(one.edges[0].z.vector(), other.edges[0].z.vector());
  EXPECT_GT(positionError(one.truth, other.truth), 1.0);
}

TEST(GraphWorld, HasADriveOnStreetsAndLoopsToPlacesNearby) {
  const auto config = smallCity();
  const auto graph = makeGraphWorld(config, 3);
  ASSERT_EQ(graph.size(), 600u);
  ASSERT_EQ(graph.truth.size(), 600u);
  int loops = 0;
  for (const auto& edge : graph.edges) {
    const Pose2 apart = graph.truth[static_cast<std::size_t>(edge.a)].between(
        graph.truth[static_cast<std::size_t>(edge.b)]);
    if (edge.isLoop()) {
      ++loops;
      EXPECT_LE(apart.position().norm(), config.loop_radius + 1e-9);
      EXPECT_GE(edge.newer() - edge.older(), config.loop_gap);
    } else {
      EXPECT_NEAR(apart.x(), 1.0, 1e-9);
      EXPECT_NEAR(apart.y(), 0.0, 1e-9);
    }
  }
  EXPECT_GT(loops, 200);
  EXPECT_LT(loops, 1000);
}

TEST(GraphWorld, StaysInTheCityAndTurnsAtItsCrossingsOnly) {
  const auto config = smallCity();
  const auto graph = makeGraphWorld(config, 4);
  const double side = 20.0;  // five blocks of 4 m: 600 poses, three in each metre of its streets
  int turns = 0;
  for (std::size_t i = 1; i < graph.size(); ++i) {
    const Pose2& pose = graph.truth[i];
    EXPECT_GE(pose.position().minCoeff(), -1e-9);
    EXPECT_LE(pose.position().maxCoeff(), side + 1e-9);
    const Pose2 step = graph.truth[i - 1].between(pose);
    if (std::abs(step.theta()) < 1e-9) continue;
    ++turns;
    EXPECT_NEAR(std::remainder(pose.x(), config.block), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(pose.y(), config.block), 0.0, 1e-9);
  }
  EXPECT_GT(turns, 30);
}

TEST(GraphWorld, ErrsAsMuchAsItsInformationTells) {
  for (const double factor : {1.0, 4.0}) {
    auto config = smallCity();
    config.sigma_position *= factor;
    config.sigma_heading *= factor;
    const auto graph = makeGraphWorld(config, 5);
    const auto errors = whitenedErrors(graph);
    Eigen::Array3d mean = Eigen::Array3d::Zero(), square = mean;
    for (const auto& e : errors) {
      mean += e.array();
      square += e.array().square();
    }
    const double count = static_cast<double>(errors.size());
    ASSERT_GT(count, 800.0);
    EXPECT_LT((mean / count).abs().maxCoeff(), 3.5 / std::sqrt(count));
    EXPECT_LT((square / count - 1.0).abs().maxCoeff(), 3.5 * std::sqrt(2.0 / count));
    EXPECT_NEAR(chi2(graph, graph.truth), square.sum(), 1e-6 * square.sum());
    EXPECT_NEAR(graph.edges[0].information(0, 0),
                1.0 / (config.sigma_position * config.sigma_position), 1e-6);
  }
}

TEST(TrajectoryError, IsWhatARigidMotionLeaves) {
  const auto truth = makeGraphWorld(smallCity(), 6).truth;
  const Pose2 T(3, -2, 2.5);
  std::vector<Pose2> moved;
  for (const auto& pose : truth) moved.push_back(T * pose);
  EXPECT_LT(positionError(moved, truth), 1e-9);
  EXPECT_LT((alignment(truth, moved).vector() - T.vector()).norm(), 1e-9);
  const double count = static_cast<double>(moved.size());
  moved[100] = T * Pose2(truth[100].x() + 1.0, truth[100].y(), 0.0);
  EXPECT_NEAR(positionError(moved, truth), 1.0 / std::sqrt(count), 1e-3 / std::sqrt(count) + 1e-4);
}

}  // namespace
}  // namespace slam::eval
