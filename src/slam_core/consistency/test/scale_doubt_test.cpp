// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/scale_doubt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

Motion motionOf(const Pose2& increment, double noise) {
  Motion motion;
  motion.increment = increment;
  motion.covariance = noise * noise * Eigen::Matrix3d::Identity();
  return motion;
}

/// A way of 20 m in which the estimate is longer and points elsewhere.
ScaleDoubt doubtAfter(double scale, double turn, double noise) {
  ScaleDoubt doubt;
  RandomStream random(1, 0);
  for (int i = 0; i < 200; ++i) {
    const Pose2 odometry(0.1 + noise * random.gaussian(), noise * random.gaussian(), 0.02);
    const double way = 0.1 * scale;
    doubt.add(motionOf(odometry, noise), Pose2(way * std::cos(turn), way * std::sin(turn), 0.02));
  }
  return doubt;
}

TEST(ScaleDoubt, FindsScaleAndTurn) {
  const auto doubt = doubtAfter(1.2, -0.1, 0.0);
  EXPECT_NEAR(doubt.difference().scale, 0.2, 1e-9);
  EXPECT_NEAR(doubt.difference().turn, -0.1, 1e-9);
  EXPECT_EQ(doubt.beyondNoise().scale, doubt.difference().scale);
  EXPECT_EQ(doubt.beyondNoise().turn, doubt.difference().turn);
}

TEST(ScaleDoubt, NoiseAloneIsNoScale) {
  const auto doubt = doubtAfter(1.0, 0.0, 0.01);
  EXPECT_EQ(doubt.beyondNoise().scale, 0.0);
  EXPECT_EQ(doubt.beyondNoise().turn, 0.0);
}

TEST(ScaleDoubt, GrowsWithTheDistanceFromWhereTheMapBegan) {
  const auto doubt = doubtAfter(1.2, 0.1, 0.0);
  const auto begin = covarianceOf(doubt.beyondNoise(), {0, 0});
  EXPECT_NEAR(begin(0, 0), 0.04 + 0.01, 1e-6) << "the first metre is out of place by both";
  const Eigen::Matrix3d P = covarianceOf(doubt.beyondNoise(), {10, 0}) - begin;
  EXPECT_NEAR(P(0, 0), 4.0 + 0.25, 1e-6) << "a fifth of 10 m along the line of sight";
  EXPECT_NEAR(P(1, 1), 1.0 + 1.0, 1e-6) << "0.1 rad at 10 m across it, and each a half of both";
}

/// With a sensor that is mounted otherwise than configured the map is turned about where it began,
/// but the robot's heading in it is right; with an odometry that points elsewhere both are right.
TEST(ScaleDoubt, DoesNotKnowHowErrorsOfPositionAndHeadingBelongTogether) {
  const auto doubt = doubtAfter(1.2, 0.1, 0.0);
  const auto P = covarianceOf(doubt.beyondNoise(), {3, 4});
  EXPECT_NEAR(std::sqrt(P(2, 2)), std::hypot(0.1, 0.5 * 0.2), 1e-6);
  EXPECT_TRUE((P.topRightCorner<2, 1>().isZero()));
  EXPECT_TRUE(P.isApprox(P.transpose()));
}

TEST(ScaleDoubt, NoDoubtIsNoCovariance) {
  EXPECT_TRUE(covarianceOf(ScaleDoubt().beyondNoise(), {3, 4}).isZero());
}

TEST(ScaleDoubt, AnOdometryThatJittersWhereTheRobotStandsTellsNothing) {
  ScaleDoubt doubt;
  RandomStream random(1, 0);
  Pose2 before;
  for (int i = 0; i < 5000; ++i) {
    const Pose2 now(0.005 * random.gaussian(), 0.005 * random.gaussian(), 0.0);
    doubt.add(motionOf(before.inverse() * now, 0.001), Pose2());
    before = now;
  }
  EXPECT_EQ(doubt.beyondNoise().scale, 0.0);
  EXPECT_TRUE(covarianceOf(doubt.beyondNoise(), {3, 4}).isZero());
}

}  // namespace
}  // namespace slam
