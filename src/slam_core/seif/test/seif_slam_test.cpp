// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/seif_slam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "slam_core/common/config_error.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::seif {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

template <class Slam>
void take(Slam& slam, const SimulatedStep& step) {
  slam.set(step.motion);
  slam.set(step.observations);
  const auto status = slam.execute();
  ASSERT_TRUE(status.isOk()) << status.message;
}

template <class Slam>
MapState stateOf(Slam& slam) {
  return as<MapKeeper>(slam).state();
}

double figureOf(const SeifSlam& slam, const std::string& name) {
  for (const auto& [each, value] : slam.figures())
    if (each == name) return value;
  ADD_FAILURE() << name;
  return 0.0;
}

SeifSlam made(int landmarks, int nodes) {
  SeifConfig config;
  config.active_landmarks = landmarks;
  config.interval_nodes = nodes;
  SeifSlam slam;
  slam.configure(config);
  return slam;
}

/// Least squares over the whole way, which marginalises nothing.
graph_slam::GraphSlam batch() {
  graph_slam::GraphSlam slam;
  slam.configure(graph_slam::GraphConfig());
  return slam;
}

TEST(SeifSlam, IsTheBatchSolutionWhileNothingIsMarginalised) {
  auto filter = made(1000, 10000);
  auto least_squares = batch();
  SimulatedWorld world(1);
  for (int i = 0; i < 20; ++i) {
    const auto step = world.next();
    take(filter, step);
    take(least_squares, step);
  }
  ASSERT_EQ(figureOf(filter, "local_maps"), 0.0);
  const auto a = stateOf(filter), b = stateOf(least_squares);
  EXPECT_LT((a.robot.pose.vector() - b.robot.pose.vector()).norm(), 1e-3);
  ASSERT_EQ(a.joint_covariance.rows(), b.joint_covariance.rows());
  EXPECT_LT((a.joint_covariance - b.joint_covariance).norm(), 1e-2 * b.joint_covariance.norm());
}

/// A pose that is let go of takes its motion along: nothing is known better for it.
TEST(SeifSlam, IsNoMoreCertainThanTheBatchSolution) {
  auto filter = made(6, 10);
  auto least_squares = batch();
  SimulatedWorld world(2);
  for (int i = 0; i < 200; ++i) {
    const auto step = world.next();
    take(filter, step);
    take(least_squares, step);
  }
  ASSERT_GT(figureOf(filter, "local_maps"), 0.0);
  const Eigen::MatrixXd P = stateOf(filter).joint_covariance,
                        P_batch = stateOf(least_squares).joint_covariance;
  ASSERT_EQ(P.rows(), P_batch.rows());
  // in every direction; linearised elsewhere, which makes a few percent
  const Eigen::LLT<Eigen::MatrixXd> L(P_batch);
  const Eigen::MatrixXd half = L.matrixL().solve(P);  // then L^-1 P L^-T
  const Eigen::MatrixXd ratio = L.matrixL().solve(half.transpose());
  EXPECT_GT(principalAxes(ratio).values(0), 0.9);
}

/// Many landmarks around the robot's circle, of which it sees a few.
std::map<LandmarkId, Eigen::Vector2d> ring() {
  constexpr int kLandmarks = 40;
  std::map<LandmarkId, Eigen::Vector2d> landmarks;
  for (int i = 0; i < kLandmarks; ++i) {
    const double angle = 2.0 * M_PI * i / kLandmarks, radius = i % 2 == 0 ? 6.0 : 7.0;
    landmarks[i] = {radius * std::cos(angle), 4.0 + radius * std::sin(angle)};
  }
  return landmarks;
}

TEST(SeifSlam, JoinsNoMoreLandmarksThanItSays) {
  auto filter = made(14, 100);
  SimulatedWorld world(3, ring());
  for (int i = 0; i < 400; ++i) {
    take(filter, world.next());
    EXPECT_LE(figureOf(filter, "most_joined_landmarks"), 21.0) << "step " << i;
  }
  EXPECT_EQ(stateOf(filter).landmarks.size(), ring().size());
  EXPECT_GT(figureOf(filter, "local_maps"), 1.0);
}

TEST(SeifSlam, DoesNotGrowWithTheWay) {
  auto filter = made(30, 20);
  SimulatedWorld world(4);
  for (int i = 0; i < 3 * SimulatedWorld::kLap; ++i) take(filter, world.next());
  const double maps = figureOf(filter, "local_maps"), memory = figureOf(filter, "factor_megabytes");
  for (int i = 0; i < 7 * SimulatedWorld::kLap; ++i) take(filter, world.next());
  EXPECT_LE(figureOf(filter, "local_maps"), maps);
  EXPECT_LT(figureOf(filter, "factor_megabytes"), 1.5 * memory);
}

/// Of a mean over the drives; 3 is expected.
TEST(SeifSlam, IsAsWrongAsItSaysAfterManyIntervals) {
  constexpr int kDrives = 20;
  double nees = 0.0;
  for (std::uint64_t seed = 0; seed < kDrives; ++seed) {
    auto filter = made(6, 10);
    SimulatedWorld world(100 + seed);
    Pose2 truth;
    for (int i = 0; i < 150; ++i) {
      const auto step = world.next();
      take(filter, step);
      truth = step.truth;
    }
    const auto estimate = filter.pose();
    Eigen::Vector3d error = estimate.pose.vector() - truth.vector();
    error.z() = std::remainder(error.z(), 2.0 * M_PI);
    nees += error.dot(estimate.covariance.inverse() * error) / kDrives;
  }
  EXPECT_LT(nees, 4.98);  // 0.9995 quantile of chi-square with 60 degrees of freedom, over 20
  EXPECT_GT(nees, 1.5);
}

TEST(SeifSlam, GoesOnWhereItIsPutElsewhere) {
  auto filter = made(6, 10);
  SimulatedWorld world(5);
  for (int i = 0; i < 60; ++i) take(filter, world.next());
  const auto size = stateOf(filter).landmarks.size();
  for (int i = 0; i < 5; ++i) {
    filter.set(filter.pose());
    EXPECT_TRUE(filter.execute().isOk());
    for (int k = 0; k < 15; ++k) take(filter, world.next());
  }
  EXPECT_GE(stateOf(filter).landmarks.size(), size);
  EXPECT_TRUE(filter.pose().covariance.allFinite());
}

/// One landmark at a time says nothing of the heading: poses between the intervals stay.
TEST(SeifSlam, KeepsItsWayWhereOneLandmarkIsSeenAtATime) {
  auto filter = made(6, 5);
  SimulatedWorld world(6);
  Pose2 truth;
  for (int i = 0; i < 100; ++i) {
    auto step = world.next();
    step.observations.observations.resize(1);
    take(filter, step);
    truth = step.truth;
  }
  EXPECT_LT((filter.pose().pose.position() - truth.position()).norm(), 0.5);
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(stateOf(filter).joint_covariance).info(), Eigen::Success);
}

/// A turn that is nearly unknown bends no local map: what was seen before it and what was seen
/// after it lie in two of them.
TEST(SeifSlam, IsTheBatchSolutionWhereATurnIsUnknown) {
  auto filter = made(30, 100);
  auto least_squares = batch();
  SimulatedWorld world(7, ring());
  std::set<LandmarkId> known;
  for (int i = 0; i < 60; ++i) {
    auto step = world.next();
    auto& seen = step.observations.observations;
    if (i == 15) {
      step.motion.increment = step.motion.increment * Pose2(0.0, 0.0, 0.5);
      step.motion.covariance(2, 2) = 0.3 * 0.3;
    }
    if (i >= 15 && i < 25)  // only new landmarks
      seen.erase(std::remove_if(seen.begin(), seen.end(),
                                [&](const auto& z) { return known.count(z.id) > 0; }),
                 seen.end());
    if (i < 15)
      for (const auto& z : seen) known.insert(z.id);
    take(filter, step);
    take(least_squares, step);
  }
  EXPECT_LT((filter.pose().pose.vector() - least_squares.pose().pose.vector()).norm(), 0.01);
}

TEST(SeifSlam, RefusesAnIntervalOfNothing) {
  SeifConfig config;
  config.active_landmarks = 0;
  SeifSlam slam;
  EXPECT_THROW(slam.configure(config), ConfigError);
}

}  // namespace
}  // namespace slam::seif
