// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/trials.hpp"

#include <gtest/gtest.h>

#include "slam_core/association/existence.hpp"
#include "slam_core/association/test/placed_landmarks.hpp"
#include "slam_core/common/random.hpp"

namespace slam::association {
namespace {

using test::observationOf;

Motion motionOf(const Pose2& increment) {
  Motion motion;
  motion.increment = increment;
  motion.covariance = Eigen::Vector3d(1e-5, 1e-5, 1e-6).asDiagonal();
  return motion;
}

/// A robot that drives along a bent way past things.
class TrialsTest : public testing::Test {
 protected:
  void drive() {
    const Pose2 increment(0.1, 0.0, 0.02);
    robot = robot * increment;
    trials.move(motionOf(increment));
    existence.move(motionOf(increment));
  }
  void see(const std::vector<Eigen::Vector2d>& places) {
    array.observations.clear();
    for (const auto& place : places) array.observations.push_back(observationOf(place, robot));
    reach.see(array);
    trials.see(array, reach);
  }
  /// What is seen from the robot at random.
  Eigen::Vector2d clutter() {
    return robot.transform({4.0 * (random.uniform() - 0.5) + 2.0, 6.0 * (random.uniform() - 0.5)});
  }

  Trials trials{3};
  Existence existence;
  SensorReach reach;
  LandmarkObservationArray array;
  Pose2 robot;
  RandomStream random{5, 0};
};

TEST_F(TrialsTest, ALandmarkIsConfirmedAfterAFewSightings) {
  const Eigen::Vector2d place(3, 1);
  int sightings = 0;
  do {
    drive();
    see({place});
    ++sightings;
  } while (!trials.isConfirmed(0) && sightings < 20);
  EXPECT_GE(sightings, 3);
  EXPECT_LE(sightings, 6);
  EXPECT_EQ(trials.size(), 1u);
}

TEST_F(TrialsTest, ClutterIsNotThoughThereIsTenTimesAsMuch) {
  const std::vector<Eigen::Vector2d> landmarks = {{3, 1}, {4, -1}};
  int confirmed = 0, of_landmarks = 0;
  for (int i = 0; i < 60; ++i) {
    drive();
    auto places = landmarks;
    for (int k = 0; k < 20; ++k) places.push_back(clutter());
    see(places);
    for (std::size_t k = 2; k < places.size(); ++k) confirmed += trials.isConfirmed(k);
    for (std::size_t k = 0; k < 2; ++k) of_landmarks += trials.isConfirmed(k);
  }
  EXPECT_LE(confirmed, 60 * 20 / 50) << "of 1200";
  EXPECT_GE(of_landmarks, 60) << "of 120";
}

TEST_F(TrialsTest, ItsTracksStayFew) {
  for (int i = 0; i < 100; ++i) {
    drive();
    std::vector<Eigen::Vector2d> places;
    for (int k = 0; k < 100; ++k) places.push_back(clutter());
    see(places);
    EXPECT_LE(trials.size(), 1200u);
  }
}

TEST_F(TrialsTest, OneSightingSufficesWhereSoConfigured) {
  trials = Trials(1);
  see({{3, 1}});
  EXPECT_TRUE(trials.isConfirmed(0));
}

/// Landmarks left and right of the way, and a ghost among them.
class ExistenceTest : public TrialsTest {
 protected:
  std::vector<LandmarkId> pass(int steps, const std::vector<Eigen::Vector2d>& seen) {
    std::vector<LandmarkPlace> landmarks = {{9, Eigen::Vector2d(3, 0)}};
    for (std::size_t i = 0; i < seen.size(); ++i)
      landmarks.push_back({static_cast<LandmarkId>(i), seen[i]});
    std::vector<LandmarkId> ghosts;
    for (int i = 0; i < steps; ++i) {
      const Pose2 increment(0, 0, i % 20 < 10 ? 0.05 : -0.05);
      robot = robot * increment;
      existence.move(motionOf(increment));
      see(seen);
      std::vector<LandmarkId> ids;
      for (std::size_t k = 0; k < seen.size(); ++k) ids.push_back(static_cast<LandmarkId>(k));
      for (const auto id : existence.see(robot, landmarks, ids, reach)) ghosts.push_back(id);
      if (!ghosts.empty()) break;
    }
    return ghosts;
  }
};

TEST_F(ExistenceTest, WhatShouldBeSeenAndIsNotIsAGhost) {
  const auto ghosts = pass(200, {{4, 0.1}, {4, 1}, {4, -1}, {5, 0.5}, {5, -0.5}});
  EXPECT_EQ(ghosts, std::vector<LandmarkId>{9});
}

TEST_F(ExistenceTest, WhatLiesBeyondTheReachIsNoGhost) {
  EXPECT_TRUE(pass(200, {{2, 0.1}, {2, 1}, {2, -1}, {2.5, 0.5}, {2.5, -0.5}}).empty());
}

TEST_F(ExistenceTest, ARobotThatStandsRemovesNothing) {
  const std::vector<Eigen::Vector2d> places = {{4, 0.1}, {4, 0.3}};
  const std::vector<LandmarkPlace> landmarks = {{9, Eigen::Vector2d(3, 0)}};
  for (int i = 0; i < 500; ++i) {
    see(places);
    EXPECT_TRUE(existence.see(robot, landmarks, {0, 1}, reach).empty());
  }
}

}  // namespace
}  // namespace slam::association
