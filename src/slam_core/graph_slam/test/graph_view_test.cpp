// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

using Kind = GraphEdge::Kind;

std::ptrdiff_t countOf(Kind kind, const GraphView& view) {
  return std::count_if(view.edges.begin(), view.edges.end(),
                       [kind](const auto& edge) { return edge.kind == kind; });
}

std::unique_ptr<GraphSlam> madeWith(MapKind map) {
  auto backend = std::make_unique<GraphSlam>();
  as<MapChooser>(*backend).useMap(map);
  backend->configure(GraphConfig());
  return backend;
}

TEST(GraphView, ShowsNodesMotionAndSightingsOfLandmarks) {
  const auto backend = madeWith(MapKind::kLandmarks);
  test::SimulatedWorld world(1);
  std::size_t used = 0;
  for (int i = 0; i < 50; ++i) {
    const auto step = world.next();
    give(step.motion, *backend);
    give(step.observations, *backend);
    backend->execute();
    used += step.observations.observations.size();
  }
  const auto view = as<GraphReporter>(*backend).graph();
  const auto nodes = static_cast<std::ptrdiff_t>(view.nodes.size());
  EXPECT_GT(nodes, 20);
  EXPECT_EQ(countOf(Kind::kMotion, view), nodes - 1) << "a chain";
  EXPECT_GT(countOf(Kind::kSighting, view), 0);
  EXPECT_LE(countOf(Kind::kSighting, view), static_cast<std::ptrdiff_t>(used));
  EXPECT_EQ(countOf(Kind::kLoop, view) + countOf(Kind::kWaitingLoop, view), 0);
  EXPECT_LT((view.nodes.back().position() - backend->pose().pose.position()).norm(), 0.2);
}

TEST(GraphView, ShowsSubmapsAndEachLoopOnce) {
  const auto backend = madeWith(MapKind::kGrid);
  test::RoomDrive drive(1);
  for (int i = 0; i < 3 * test::RoomDrive::kLap; ++i) {
    const auto step = drive.next();
    give(step.motion, *backend);
    give(step.scan, *backend);
    backend->execute();
  }
  const auto view = as<GraphReporter>(*backend).graph();
  const auto loops = countOf(Kind::kLoop, view), waiting = countOf(Kind::kWaitingLoop, view);
  double all = 0.0, rejected = 0.0;
  for (const auto& [name, value] : backend->figures()) {
    if (name == "loops") all = value;
    if (name == "rejected_loops") rejected = value;
  }
  EXPECT_GT(loops, 10);
  EXPECT_EQ(static_cast<double>(waiting), rejected);
  EXPECT_EQ(static_cast<double>(loops + waiting), all);
  EXPECT_EQ(countOf(Kind::kMotion, view), static_cast<std::ptrdiff_t>(view.nodes.size()) - 1);
  EXPECT_GT(view.submaps.size(), 1u);
  for (const auto& edge : view.edges) EXPECT_EQ(edge.weight > 0.0, edge.kind != Kind::kWaitingLoop);
}

TEST(LoopWatch, TellsTheLoopsOfAScanAndHowFarTheyMovedTheRobot) {
  LoopWatch watch;
  watch.note({3, 1}, Pose2(1, 0, 0), Pose2(1, 0.5, 0.2));
  ASSERT_EQ(watch.events().size(), 1u);
  EXPECT_EQ(watch.events()[0].kind, Event::Kind::kLoopClosed);
  EXPECT_NEAR(watch.events()[0].distance, 0.5, 1e-12);
  EXPECT_NEAR(watch.events()[0].turn, 0.2, 1e-12);
  watch.begin();
  EXPECT_TRUE(watch.events().empty());
  watch.note({3, 1}, Pose2(), Pose2());
  EXPECT_TRUE(watch.events().empty()) << "nothing new";
  watch.note({3, 2}, Pose2(), Pose2());
  ASSERT_EQ(watch.events().size(), 1u);
  EXPECT_EQ(watch.events()[0].kind, Event::Kind::kLoopTakenBack);
}

}  // namespace
}  // namespace slam::graph_slam
