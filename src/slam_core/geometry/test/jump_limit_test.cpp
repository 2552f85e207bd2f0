// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/jump_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam {
namespace {

constexpr double kTolerance = 1e-9;

Stamp at(double seconds) { return Stamp(durationFromSeconds(seconds)); }

/// @return how far the robot is from where it was shown, [m] and [rad]
Eigen::Vector2d moved(const Pose2& from, const Pose2& to) {
  const Pose2 step = from.between(to);
  return {step.position().norm(), std::abs(step.theta())};
}

TEST(JumpLimit, JumpsWithTheEstimateUnlessALimitIsSet) {
  JumpLimit limit({});
  limit.follow(at(0.0), Pose2(), Pose2());
  const Pose2 T_map_base(3, -2, 1), T_odom_base(1, 0, 0.5);
  const Pose2 T_map_odom = limit.follow(at(0.1), T_map_base, T_odom_base);
  EXPECT_LT(moved(T_map_odom * T_odom_base, T_map_base).norm(), kTolerance);
}

TEST(JumpLimit, BeginsWhereTheEstimateIs) {
  JumpLimit limit({0.1, 0.1});
  EXPECT_LT(moved(limit.follow(at(5.0), Pose2(3, 4, 1), Pose2()), Pose2(3, 4, 1)).norm(),
            kTolerance);
}

TEST(JumpLimit, MovesTheRobotAsFastAsItMayAndArrives) {
  const JumpLimit::Limits limits{0.5, 0.2};
  JumpLimit limit(limits);
  const Pose2 estimate(1.0, 0.5, 0.1), T_odom_base(100, 0, 0);  // odom begins far away
  Pose2 shown = limit.follow(at(0.0), T_odom_base, T_odom_base) * T_odom_base;
  const Pose2 corrected = T_odom_base * estimate;
  int steps = 0;
  for (; moved(shown, corrected).norm() > kTolerance && steps < 100; ++steps) {
    const Pose2 next = limit.follow(at(0.1 * (steps + 1)), corrected, T_odom_base) * T_odom_base;
    const auto step = moved(shown, next);
    EXPECT_LE(step.x(), limits.speed * 0.1 + kTolerance);
    EXPECT_LE(step.y(), limits.turn_rate * 0.1 + kTolerance);
    shown = next;
  }
  EXPECT_EQ(steps, 23) << "1.12 m at 0.5 m/s, in steps of 0.1 s";
}

TEST(JumpLimit, LimitsATurnOnTheSpot) {
  JumpLimit limit({0.5, 0.2});
  limit.follow(at(0.0), Pose2(), Pose2());
  EXPECT_NEAR(limit.follow(at(1.0), Pose2(0, 0, 1), Pose2()).theta(), 0.2, kTolerance);
}

/// What odometry moves is no correction.
TEST(JumpLimit, LetsTheRobotDriveAsItLikes) {
  JumpLimit limit({0.01, 0.01});
  limit.follow(at(0.0), Pose2(), Pose2());
  const Pose2 driven(10, 5, 2);
  EXPECT_LT(moved(limit.follow(at(0.1), driven, driven), Pose2()).norm(), kTolerance);
}

TEST(JumpLimit, TakesAGapOfStampsForOneSecond) {
  JumpLimit limit({0.5, 0.2});
  limit.follow(at(0.0), Pose2(), Pose2());
  EXPECT_NEAR(limit.follow(at(60.0), Pose2(10, 0, 0), Pose2()).x(), 0.5, kTolerance);
}

TEST(JumpLimit, StaysWhereStampsGoBack) {
  JumpLimit limit({0.5, 0.2});
  limit.follow(at(10.0), Pose2(), Pose2());
  EXPECT_EQ(limit.follow(at(9.0), Pose2(10, 0, 0), Pose2()).x(), 0.0);
}

TEST(JumpLimit, JumpsAfterARestart) {
  JumpLimit limit({0.5, 0.2});
  limit.follow(at(0.0), Pose2(), Pose2());
  limit.restart();
  EXPECT_NEAR(limit.follow(at(0.1), Pose2(10, 0, 0), Pose2()).x(), 10.0, kTolerance);
}

}  // namespace
}  // namespace slam
