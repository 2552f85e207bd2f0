// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/odometry_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/mono_ekf/mono_state.hpp"

namespace slam::mono_ekf {
namespace {

constexpr double kShare = 0.5;
constexpr double kOfMetre = 2e-3, kOfRadian = 1e-2;  // [rad^2]

Motion motionBy(double way, double turn) {
  Motion motion;
  motion.increment = Pose2(way, 0.0, turn);
  motion.covariance.diagonal() << 1e-4 * std::abs(way) + 1e-9, 1e-9,
      kOfMetre * std::abs(way) + kOfRadian * std::abs(turn);
  return motion;
}

TEST(OdometryErrors, FindsWhatIsClaimedForAMetreAndForARadian) {
  OdometryErrors errors(kShare);
  errors.divide(motionBy(0.02, 0.0));
  errors.divide(motionBy(0.02, 0.01));
  const auto divided = errors.divide(motionBy(-0.02, -0.03));
  EXPECT_NEAR(divided.J_errors(2, 0), -0.03 * std::sqrt(kShare * kOfRadian), 1e-6);
  EXPECT_NEAR(divided.J_errors(2, 1), -0.02 * std::sqrt(kShare * kOfMetre), 1e-6);
  EXPECT_TRUE(divided.J_errors.topRows<2>().isZero(0.0)) << "only the heading errs alike";
}

TEST(OdometryErrors, LeavesTheRestOfTheVarianceToChance) {
  OdometryErrors errors(kShare);
  const auto motion = motionBy(0.02, 0.01);
  const auto divided = errors.divide(motion);
  EXPECT_DOUBLE_EQ(divided.random.covariance(2, 2), (1.0 - kShare) * motion.covariance(2, 2));
  EXPECT_EQ(divided.random.covariance(0, 0), motion.covariance(0, 0));
}

TEST(OdometryErrors, AMotionThatSeemsNotToTurnAmongTurnsClaimsWhatTheyDo) {
  OdometryErrors errors(kShare);
  DividedMotion turning;
  errors.divide(motionBy(0.02, 0.0));  // tells metres from radians
  for (int i = 0; i < 100; ++i) turning = errors.divide(motionBy(0.02, 0.05));
  const auto divided = errors.divide(motionBy(0.02, 0.0));
  EXPECT_NEAR(divided.random.covariance(2, 2), turning.random.covariance(2, 2), 1e-7);
  for (int i = 0; i < 100; ++i) errors.divide(motionBy(0.02, 0.0));
  EXPECT_NEAR(errors.divide(motionBy(0.02, 0.0)).random.covariance(2, 2),
              (1.0 - kShare) * kOfMetre * 0.02, 1e-7)
      << "it goes straight by now";
}

TEST(OdometryErrors, ARobotThatStandsErrsAtRandom) {
  OdometryErrors errors(kShare);
  const auto motion = motionBy(0.0, 0.0);
  const auto divided = errors.divide(motion);
  EXPECT_TRUE(divided.J_errors.isZero(0.0));
  EXPECT_EQ(divided.random.covariance, motion.covariance);
}

/// The heading's variance after straight ways, in the dark.
double headingVariance(double metres) {
  OdometryErrors errors(kShare);
  MonoState state(PoseEstimate{Pose2(), 1e-12 * Eigen::Matrix3d::Identity()});
  for (int i = 0; i < static_cast<int>(50 * metres); ++i)
    state.predict(errors.divide(motionBy(0.02, 0.0)));
  return state.robot().covariance(2, 2);
}

TEST(MonoState, AfterAMetreItsHeadingErrsAsOdometryClaims) {
  EXPECT_NEAR(headingVariance(1.0), kOfMetre, 1e-6);
}

TEST(MonoState, OverLongWaysItsHeadingErrsWithTheWay) {
  const double length = 10.0;
  EXPECT_NEAR(headingVariance(length),
              kOfMetre * ((1.0 - kShare) * length + kShare * length * length), 1e-4);
}

}  // namespace
}  // namespace slam::mono_ekf
