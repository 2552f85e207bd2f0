// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/association/test/toy_policies.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::graph_slam {
namespace {

using association::test::removeIds;

class GraphPlacePolicyTest : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Of, GraphPlacePolicyTest, testing::Values("nearest", "jcbb"),
                         [](const auto& policy) { return std::string(policy.param); });

TEST_P(GraphPlacePolicyTest, MapsTheWorldWithoutIds) {
  GraphConfig config;
  config.association = GetParam();
  GraphSlam graph;
  graph.configure(config);
  test::SimulatedWorld world(4);
  Pose2 truth;
  for (int i = 0; i < 200; ++i) {
    auto step = world.next();
    removeIds(step.observations);
    graph.set(step.motion);
    graph.set(step.observations);
    EXPECT_TRUE(graph.execute().isOk());
    truth = step.truth;
  }
  const auto map = as<LandmarkMapper>(graph).landmarks();
  EXPECT_EQ(map.size(), world.landmarks().size());
  for (const auto& landmark : map) {
    double error = 1e9;
    for (const auto& [id, place] : world.landmarks())
      error = std::min(error, (place - landmark.position).norm());
    EXPECT_LT(error, 0.4);
  }
  const auto pose = graph.pose();
  EXPECT_LT(test::nees(truth, pose.pose, pose.covariance), 16.0);
  EXPECT_GT(graph.counters()["on_trial"], 0u);
}

}  // namespace
}  // namespace slam::graph_slam
