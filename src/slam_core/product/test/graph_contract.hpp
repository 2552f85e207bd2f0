// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/contract/session_merger.hpp"
#include "slam_core/product/test/driven_backend.hpp"

// These contracts hold for a back-end that estimates a graph of poses, and for one that reports
// events.

namespace slam::test {

class GraphContract : public ContractTest {
 protected:
  static GraphView graphOf(const DrivenBackend& backend) {
    return backend.as<GraphReporter>().graph();
  }
  static bool joinsPoses(const GraphEdge& edge) { return edge.kind != GraphEdge::Kind::kSighting; }
  static bool isNode(const GraphView& graph, const Eigen::Vector2d& place) {
    return std::any_of(graph.nodes.begin(), graph.nodes.end(),
                       [&](const Pose2& node) { return node.position() == place; });
  }
};
// A back-end that keeps no graph has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GraphContract);

TEST_P(GraphContract, ItsNodesAreWhereTheRobotWas) {
  auto backend = make();
  EXPECT_TRUE(graphOf(backend).nodes.empty()) << "nothing before the first step";
  backend.run(1, 100);
  const auto graph = graphOf(backend);
  ASSERT_FALSE(graph.nodes.empty());
  const auto robot = backend->pose().pose.position();
  EXPECT_LT((graph.nodes.back().position() - robot).norm(), 1.0) << "the newest comes last";
}

TEST_P(GraphContract, ItsEdgesHoldAndJoinItsNodes) {
  auto backend = make();
  backend.run(2, 200);
  const auto graph = graphOf(backend);
  ASSERT_FALSE(graph.edges.empty());
  for (const auto& edge : graph.edges) {
    ASSERT_TRUE(edge.from.allFinite() && edge.to.allFinite());
    ASSERT_TRUE(edge.weight >= 0.0 && edge.weight <= 1.0) << edge.weight;
    ASSERT_TRUE(isNode(graph, edge.from));
    ASSERT_TRUE(!joinsPoses(edge) || isNode(graph, edge.to));
  }
}

TEST_P(GraphContract, IsEmptyAfterReset) {
  auto backend = make();
  backend.run(3, 50);
  backend->reset();
  EXPECT_TRUE(graphOf(backend).nodes.empty());
  EXPECT_TRUE(graphOf(backend).edges.empty());
}

class EventContract : public ContractTest {
 protected:
  static std::vector<Event> eventsOf(const DrivenBackend& backend) {
    return backend.as<EventReporter>().events();
  }
  /// A back-end, begun anew, that merges sessions is to meet the drive of the same seed again.
  static void remember(DrivenBackend& backend, std::uint64_t seed) {
    auto* merger = backend.find<SessionMerger>();
    if (merger == nullptr) return;
    backend.run(seed, backend.drive(seed)->stepsOfALap());
    const auto session = backend.as<SessionKeeper>().session();
    backend->reset();
    merger->merge(session);
  }
};
// A back-end that tells nothing has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EventContract);

TEST_P(EventContract, TellsSizesAndReasonsThatFilesCanHold) {
  auto backend = make();
  remember(backend, 1);
  const auto drive = backend.drive(1);
  std::size_t told = 0;
  for (int i = 0; i < 3 * drive->stepsOfALap(); ++i) {
    backend.step(*drive);
    for (const auto& event : eventsOf(backend)) {
      ++told;
      ASSERT_TRUE(std::isfinite(event.distance) && event.distance >= 0.0);
      ASSERT_TRUE(std::isfinite(event.turn) && event.turn >= 0.0);
      ASSERT_FALSE(event.reason.empty());
      ASSERT_EQ(event.reason.find_first_of("\"\n"), std::string::npos) << event.reason;
    }
  }
  EXPECT_GT(told, 0u) << "in three laps the robot comes back to where it was";
}

TEST_P(EventContract, TellsOnlyOfTheLastStep) {
  auto backend = make();
  remember(backend, 2);
  const auto drive = backend.drive(2);
  int steps = 0;
  while (eventsOf(backend).empty() && ++steps < 3 * drive->stepsOfALap()) backend.step(*drive);
  ASSERT_FALSE(eventsOf(backend).empty());
  backend.execute();
  EXPECT_TRUE(eventsOf(backend).empty()) << "a step without data";
}

}  // namespace slam::test
