// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/path_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "slam_core/association/test/placed_landmarks.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::graph_slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

GraphConfig reduced(int nodes_per_place = 1) {
  GraphConfig config;
  config.nodes_per_place = nodes_per_place;
  return config;
}

/// Nothing is removed with it.
GraphConfig whole() { return reduced(1000000); }

double figureOf(const GraphSlam& graph, const std::string& name) {
  for (const auto& [each, value] : graph.figures())
    if (each == name) return value;
  ADD_FAILURE() << "there is no figure " << name;
  return NAN;
}

/// A back-end in a world of its own.
struct Drive {
  explicit Drive(const GraphConfig& config, std::uint64_t seed = 1) : world(seed) {
    graph.configure(config);
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = world.next();
      graph.set(step.motion);
      graph.set(step.observations);
      ASSERT_NE(graph.execute().level, Status::Level::kError);
      truth.push_back(step.truth);
    }
  }
  double error() const { return (graph.pose().pose.position() - truth.back().position()).norm(); }

  SimulatedWorld world;
  GraphSlam graph;
  std::vector<Pose2> truth;
};

/// Each lap is a little beside the last one, since the robot drives with noise.
TEST(PathReduction, KeepsTheGraphAsLargeAsTheArea) {
  Drive drive(reduced(3));
  drive.run(6 * SimulatedWorld::kLap);
  const double nodes = figureOf(drive.graph, "nodes");
  const double megabytes = figureOf(drive.graph, "factor_megabytes");
  drive.run(8 * SimulatedWorld::kLap);
  EXPECT_LT(figureOf(drive.graph, "nodes"), 1.1 * nodes);
  EXPECT_LT(figureOf(drive.graph, "factor_megabytes"), 1.2 * megabytes);
  EXPECT_GT(figureOf(drive.graph, "removed_nodes"), 7 * SimulatedWorld::kLap);
}

TEST(PathReduction, RemovesNothingBeforeAPlaceIsFull) {
  Drive drive(whole());
  drive.run(3 * SimulatedWorld::kLap);
  EXPECT_EQ(figureOf(drive.graph, "removed_nodes"), 0.0);
}

/// A robot sees the same landmarks from everywhere, and comes to no place twice: what it sees from
/// its way tells the map, all of it.
TEST(PathReduction, KeepsAllOfTheFirstPassOverAPlace) {
  GraphSlam graph;
  graph.configure(GraphConfig());
  const std::vector<Eigen::Vector2d> landmarks = {{3.0, 8.0}, {10.0, 8.0}, {17.0, 8.0}};
  Motion motion;
  motion.increment = Pose2(GraphConfig().node_distance, 0.0, 0.0);
  motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  Pose2 robot;
  for (int i = 0; i < 400; ++i) {
    motion.start = std::exchange(motion.end, motion.end + std::chrono::milliseconds(100));
    robot = robot * motion.increment;
    LandmarkObservationArray array;
    array.stamp = motion.end;
    for (std::size_t id = 0; id < landmarks.size(); ++id) {
      array.observations.push_back(association::test::observationOf(landmarks[id], robot));
      array.observations.back().id = static_cast<LandmarkId>(id);
    }
    graph.set(motion);
    graph.set(array);
    ASSERT_TRUE(graph.execute().isOk());
  }
  EXPECT_EQ(figureOf(graph, "removed_nodes"), 0.0);
}

/// What is left out is information.
TEST(PathReduction, NeverKnowsMoreThanTheWholeGraph) {
  Drive all(whole()), few(reduced());
  for (int lap = 0; lap < 6; ++lap) {
    all.run(SimulatedWorld::kLap);
    few.run(SimulatedWorld::kLap);
    const double ratio = few.graph.pose().covariance.trace() / all.graph.pose().covariance.trace();
    EXPECT_GT(ratio, 0.98) << "lap " << lap;
    EXPECT_LT(ratio, 4.0) << "lap " << lap;
  }
  EXPECT_GT(figureOf(few.graph, "removed_nodes"), 300.0);
}

TEST(PathReduction, LeavesErrorsAsSmallAsTheyAreTold) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Drive drive(reduced(), seed);
    for (int lap = 0; lap < 6; ++lap) {
      drive.run(SimulatedWorld::kLap);
      const auto [pose, covariance] = drive.graph.pose();
      const Eigen::Vector3d error = drive.truth.back().between(pose).log();
      sum += error.dot(twistCovariance(pose, covariance).ldlt().solve(error));
      ++count;
    }
  }
  EXPECT_LT(sum / count, 4.5) << "3 are expected";
}

TEST(PathReduction, LeavesAPoseForEachStep) {
  Drive drive(reduced());
  drive.run(5 * SimulatedWorld::kLap);
  ASSERT_GT(figureOf(drive.graph, "removed_nodes"), 100.0);
  const auto path = as<PathReviser>(drive.graph).path();
  ASSERT_EQ(path.size(), drive.truth.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_LT((path[i].pose.position() - drive.truth[i].position()).norm(), 0.3) << "step " << i;
    EXPECT_LT(path[i > 0 ? i - 1 : 0].stamp,
              path[i].stamp + std::chrono::nanoseconds(i > 0 ? 0 : 1));
  }
}

TEST(PathReduction, KeepsNothingButTheRecentNodesInAFixedMap) {
  Drive mapping(reduced());
  mapping.run(3 * SimulatedWorld::kLap);
  auto config = reduced();
  config.mode = BackendMode::kLocalization;
  GraphSlam localising;
  localising.configure(config);
  auto map = as<MapKeeper>(mapping.graph).state();
  for (const bool has_joint : {true, false}) {
    if (!has_joint) map.joint_covariance = {};
    localising.reset();
    as<MapKeeper>(localising).set(map);
    localising.execute();
    const auto before = as<LandmarkMapper>(localising).landmarks();
    auto world = mapping.world;
    for (int i = 0; i < 4 * SimulatedWorld::kLap; ++i) {
      const auto step = world.next();
      localising.set(step.motion);
      localising.set(step.observations);
      localising.execute();
      ASSERT_LE(figureOf(localising, "nodes"), 110.0);
      ASSERT_LT((localising.pose().pose.position() - step.truth.position()).norm(), 0.3);
    }
    const auto after = as<LandmarkMapper>(localising).landmarks();
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].position, before[i].position);
    EXPECT_EQ(as<PathReviser>(localising).path().size(), std::size_t{4} * SimulatedWorld::kLap);
  }
}

/// All landmarks are taken away and others hung up.
void replaceLandmarks(SimulatedStep& step) {
  auto& seen = step.observations.observations;
  seen.erase(std::remove_if(seen.begin(), seen.end(), [](auto& z) { return z.id < 20; }),
             seen.end());
  for (auto& z : seen) z.id += 100;
}

/// Where the places are full of nodes, what is seen later must still hang together with what was
/// seen before.
TEST(PathReduction, StaysDeterminedWhereAllLandmarksAreReplaced) {
  Drive all(whole()), few(reduced());
  all.run(4 * SimulatedWorld::kLap);
  few.run(4 * SimulatedWorld::kLap);
  for (int lap = 0; lap < 4; ++lap) {
    for (int i = 0; i < SimulatedWorld::kLap; ++i)
      for (auto* drive : {&all, &few}) {
        auto step = drive->world.next();
        replaceLandmarks(step);
        drive->graph.set(step.motion);
        drive->graph.set(step.observations);
        const auto status = drive->graph.execute();
        ASSERT_TRUE(status.isOk()) << "step " << i << ": " << status.message;
      }
    const double ratio = few.graph.pose().covariance.trace() / all.graph.pose().covariance.trace();
    EXPECT_LT(ratio, 4.0) << "twice the sigma, lap " << lap;
  }
  const auto step = few.world.next();
  few.graph.set(step.motion);
  few.graph.execute();
  const auto robot = few.graph.pose();
  EXPECT_LT(test::nees(step.truth, robot.pose, robot.covariance), 16.3) << "0.999 of the errors";
}

TEST(PathReduction, BeginsAnewWithAReset) {
  Drive fresh(reduced()), used(reduced(), 2);
  used.run(4 * SimulatedWorld::kLap);
  used.graph.reset();
  EXPECT_EQ(figureOf(used.graph, "removed_nodes"), 0.0);
  used.world = SimulatedWorld(1);
  fresh.run(4 * SimulatedWorld::kLap);
  used.run(4 * SimulatedWorld::kLap);
  EXPECT_GT(figureOf(fresh.graph, "removed_nodes"), 0.0);
  EXPECT_EQ(fresh.graph.pose().pose.vector(), used.graph.pose().pose.vector());
  EXPECT_EQ(fresh.graph.pose().covariance, used.graph.pose().covariance);
}

TEST(PathReduction, GoesOnWithAMapThatIsLoadedInBetween) {
  Drive drive(reduced());
  drive.run(4 * SimulatedWorld::kLap);
  as<MapKeeper>(drive.graph).set(as<MapKeeper>(drive.graph).state());
  drive.run(4 * SimulatedWorld::kLap);
  EXPECT_LT(drive.error(), 0.2);
  EXPECT_GT(figureOf(drive.graph, "removed_nodes"), 0.0);
}

TEST(PathReduction, IsNoNeedOfARobotThatStandsStill) {
  Drive drive(reduced());
  drive.run(SimulatedWorld::kLap);
  const double nodes = figureOf(drive.graph, "nodes");
  auto step = drive.world.next();
  step.motion.increment = Pose2();
  step.motion.covariance = 1e-12 * Eigen::Matrix3d::Identity();
  step.observations.observations.clear();
  for (int i = 0; i < 5000; ++i) {
    drive.graph.set(step.motion);
    drive.graph.set(step.observations);
    drive.graph.execute();
  }
  EXPECT_LE(figureOf(drive.graph, "nodes"), nodes + 1.0);
}

/// Motion may be as uncertain as an input may be (`kLargestInputSigmaLength`).
TEST(PathReduction, BearsMotionOfWhichNothingIsKnown) {
  Drive drive(reduced());
  drive.run(2 * SimulatedWorld::kLap);
  for (int i = 0; i < 3 * SimulatedWorld::kLap; ++i) {
    auto step = drive.world.next();
    step.motion.covariance = Eigen::Vector3d(1e6, 1e6, 1e2).asDiagonal();
    drive.graph.set(step.motion);
    drive.graph.set(step.observations);
    ASSERT_NE(drive.graph.execute().level, Status::Level::kError);
    ASSERT_TRUE(drive.graph.pose().pose.isFinite());
    ASSERT_TRUE(drive.graph.pose().covariance.allFinite());
  }
}

}  // namespace
}  // namespace slam::graph_slam
