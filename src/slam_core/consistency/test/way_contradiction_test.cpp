// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/way_contradiction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

Motion moved(const Pose2& increment, double sigma) {
  Motion motion;
  motion.increment = increment;
  motion.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
  return motion;
}

/// Steps of the same increments.
void drive(WayContradiction& ways, int steps, const Pose2& odometry, const Pose2& estimated) {
  for (int i = 0; i < steps; ++i) ways.add(moved(odometry, 0.002), estimated);
}

const Pose2 kAhead(0.05, 0, 0.01), kBack(-0.05, 0, -0.01), kStill(0, 0, 0);

TEST(WayContradiction, IsEvidentWhereOneStandsStillAndTheOtherDoesNot) {
  for (const bool odometry_stands : {true, false}) {
    WayContradiction ways;
    drive(ways, 11, odometry_stands ? kStill : kAhead, odometry_stands ? kAhead : kStill);
    EXPECT_FALSE(ways.isEvident()) << "within less than two pieces of 0.3 m";
    drive(ways, 5, odometry_stands ? kStill : kAhead, odometry_stands ? kAhead : kStill);
    EXPECT_TRUE(ways.isEvident());
  }
}

TEST(WayContradiction, IsEvidentWhereTheyTurnToOppositeSides) {
  WayContradiction ways;
  drive(ways, 20, {0, 0, 0.05}, {0, 0, -0.05});
  EXPECT_TRUE(ways.isEvident());
}

TEST(WayContradiction, IsEvidentWhereTheyTurnToOppositeSidesOnTheWay) {
  WayContradiction ways;
  drive(ways, 50, {0.05, 0, 0.02}, {0.05, 0, -0.02});
  EXPECT_TRUE(ways.isEvident());
  EXPECT_NEAR(ways.apart().heading, 2.0, 0.1);
}

TEST(WayContradiction, AddsUpHowFarTheTwoHaveLedApart) {
  WayContradiction ways;
  drive(ways, 100, {0.05, 0, 0}, kStill);
  EXPECT_NEAR(ways.apart().position, 5.0, 0.05);
  EXPECT_LT(ways.apart().heading, 0.05);
  drive(ways, 100, kBack, kBack);
  EXPECT_EQ(ways.apart().position, 0.0) << "both agree by now";
}

TEST(WayContradiction, TheOdometrysNoiseAddsToThat) {
  WayContradiction ways;
  for (int i = 0; i < 100; ++i) ways.add(moved({0.05, 0, 0}, 0.01), kStill);
  for (int i = 0; i < 100; ++i) ways.add(moved({-0.05, 0, 0}, 0.01), kStill);
  EXPECT_GT(ways.apart().position, 0.19) << "0.01 sqrt(2 200), and more by the heading";
  EXPECT_NEAR(ways.apart().heading, 0.01 * std::sqrt(200), 1e-3);
}

TEST(WayContradiction, LastsUntilTheWaysHaveAgreedForTwoMetres) {
  const Pose2 straight(0.05, 0, 0);
  WayContradiction ways;
  drive(ways, 50, straight, kStill);
  drive(ways, 30, straight, straight);
  EXPECT_TRUE(ways.isEvident());
  drive(ways, 30, straight, straight);
  EXPECT_FALSE(ways.isEvident());
}

TEST(WayContradiction, OfTurnsLastsForTenMetresWithoutAny) {
  const Pose2 straight(0.05, 0, 0);
  WayContradiction ways;
  drive(ways, 50, {0.05, 0, 0.02}, {0.05, 0, -0.02});
  drive(ways, 190, straight, straight);
  EXPECT_TRUE(ways.isEvident());
  drive(ways, 60, straight, straight);
  EXPECT_FALSE(ways.isEvident());
}

TEST(WayContradiction, AWrongScaleIsNone) {
  for (const double scale : {0.7, 1.3}) {
    WayContradiction ways;
    for (int i = 0; i < 500; ++i) {
      ways.add(moved({0.05 * scale, 0, 0.02 * scale}, 0.002), {0.05, 0, 0.02});
      ASSERT_FALSE(ways.isEvident()) << scale;
    }
  }
}

TEST(WayContradiction, OneLargeCorrectionIsNone) {
  WayContradiction ways;
  drive(ways, 50, kAhead, kAhead);
  ways.add(moved(kAhead, 0.002), {2.0, 1.0, 0.5});
  for (int i = 0; i < 50; ++i) {
    ways.add(moved(kAhead, 0.002), kAhead);
    ASSERT_FALSE(ways.isEvident());
  }
}

TEST(WayContradiction, NoiseThatTheOdometryReportsIsNone) {
  WayContradiction ways;
  RandomStream random(3, 0);
  const double sigma = 0.15;
  for (int i = 0; i < 20000; ++i) {
    const Pose2 noisy(0.05 + sigma * random.gaussian(), sigma * random.gaussian(),
                      sigma * random.gaussian());
    ways.add(moved(noisy, sigma), {0.05, 0, 0});
    ASSERT_FALSE(ways.isEvident()) << i;
  }
}

}  // namespace
}  // namespace slam
