// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

Motion goodMotion() {
  Motion motion;
  motion.sequence = 4;
  motion.start = at(10);
  motion.end = at(12);
  motion.increment = Pose2(1.0, 0.3, 0.8);
  motion.covariance << 0.02, 0.001, 0, 0.001, 0.03, 0.004, 0, 0.004, 0.05;
  motion.odometry_start = Pose2(5, 6, 2);
  motion.odometry_end = motion.odometry_start * motion.increment;
  motion.odometry_frame = "odom";
  motion.base_frame = "base_link";
  return motion;
}

void expectSame(const Pose2& a, const Pose2& b) {
  EXPECT_LT((a.vector() - b.vector()).norm(), 1e-12)
      << a.vector().transpose() << " and " << b.vector().transpose();
}

TEST(MotionSplit, DividesTimeIncrementAndCovariance) {
  const auto whole = goodMotion();
  const auto [before, after] = split(whole, at(10.5));
  EXPECT_EQ(before.start, at(10));
  EXPECT_EQ(before.end, at(10.5));
  EXPECT_EQ(after.start, at(10.5));
  EXPECT_EQ(after.end, at(12));
  expectSame(before.increment, Pose2::exp(0.25 * whole.increment.log()));
  expectSame(before.increment * after.increment, whole.increment);
  EXPECT_TRUE(before.covariance.isApprox(0.25 * whole.covariance, 1e-12));
  EXPECT_TRUE(after.covariance.isApprox(0.75 * whole.covariance, 1e-12));
  EXPECT_EQ(before.sequence, 4u);
  EXPECT_EQ(after.odometry_frame, "odom");
}

TEST(MotionSplit, KeepsTheOdometryPosesOfBothEnds) {
  const auto whole = goodMotion();
  const auto [before, after] = split(whole, at(10.5));
  expectSame(before.odometry_start, whole.odometry_start);
  expectSame(before.odometry_end, whole.odometry_start * before.increment);
  expectSame(after.odometry_start, before.odometry_end);
  expectSame(after.odometry_end, whole.odometry_end);
}

TEST(MotionSplit, FollowsTheDriversOwnPathWhereTheIncrementIsCalibrated) {
  auto whole = goodMotion();
  const Pose2 driven(1.1, 0.2, 0.9);  // what the driver integrated, unlike the corrected increment
  whole.odometry_end = whole.odometry_start * driven;
  const auto [before, after] = split(whole, at(11));
  expectSame(before.odometry_end, whole.odometry_start * driven.part(0.5));
  expectSame(after.odometry_start, before.odometry_end);
  expectSame(after.odometry_end, whole.odometry_end);
  expectSame(before.increment * after.increment, whole.increment);
}

TEST(MotionSplit, MayBeRepeated) {
  const auto whole = goodMotion();
  const auto [first, rest] = split(whole, at(10.5));
  const auto [second, third] = split(rest, at(11));
  expectSame(first.increment * second.increment * third.increment, whole.increment);
  EXPECT_TRUE(Eigen::Matrix3d(first.covariance + second.covariance + third.covariance)
                  .isApprox(whole.covariance, 1e-12));
}

TEST(MotionFault, IsEmptyForAGoodMotion) { EXPECT_EQ(faultOf(goodMotion()), ""); }

TEST(MotionFault, FindsWhatIsNotANumber) {
  const double nan = std::nan("");
  auto motion = goodMotion();
  motion.increment = Pose2(nan, 0, 0);
  EXPECT_NE(faultOf(motion).find("not a number"), std::string::npos);
  motion = goodMotion();
  motion.odometry_end = Pose2(0, 0, nan);
  EXPECT_NE(faultOf(motion).find("not a number"), std::string::npos);
  motion = goodMotion();
  motion.covariance(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_NE(faultOf(motion).find("not a number"), std::string::npos);
}

TEST(MotionFault, FindsAnIntervalThatIsNotPositive) {
  auto motion = goodMotion();
  motion.end = motion.start;
  EXPECT_NE(faultOf(motion), "");
  motion.end = at(9);
  EXPECT_NE(faultOf(motion).find("before it starts"), std::string::npos);
}

TEST(MotionFault, FindsACovarianceThatIsNone) {
  for (const int axis : {0, 1, 2}) {
    auto motion = goodMotion();
    motion.covariance(axis, axis) = -0.01;
    EXPECT_NE(faultOf(motion).find("positive definite"), std::string::npos);
  }
  auto motion = goodMotion();
  motion.covariance.setZero();
  EXPECT_NE(faultOf(motion).find("positive definite"), std::string::npos);
  motion = goodMotion();
  motion.covariance(0, 1) += 0.005;  // no longer symmetric
  EXPECT_NE(faultOf(motion).find("positive definite"), std::string::npos);
}

Motion plainMotion() {
  Motion motion;
  motion.end = motion.start + std::chrono::milliseconds(50);
  motion.increment = Pose2(0.05, 0, 0.01);
  motion.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  return motion;
}

TEST(MotionFault, NamesValuesThatNoRobotsOdometryHas) {
  EXPECT_EQ(faultOf(plainMotion()), "");
  for (const double far : {1e3, 1e6, 1e300}) {
    auto motion = plainMotion();
    motion.increment = Pose2(far, -far, 0);
    EXPECT_NE(faultOf(motion).find("which no robot drives"), std::string::npos) << far;
  }
  for (const double far : {1e10, 1e300}) {
    auto motion = plainMotion();
    motion.odometry_end = Pose2(0, far, 0);
    EXPECT_NE(faultOf(motion).find("m from its origin"), std::string::npos) << far;
  }
}

TEST(MotionFault, IsNotThatMessagesCameInABurst) {
  auto motion = plainMotion();
  motion.end = motion.start + std::chrono::microseconds(100);
  motion.increment = Pose2(3, 0, 0);
  EXPECT_EQ(faultOf(motion), "");
}

TEST(MotionFault, FindsACovarianceThatIsAbsurdlyLarge) {
  auto motion = goodMotion();
  motion.covariance = Eigen::Vector3d(1e6, 1e6, 100.0).asDiagonal();
  EXPECT_EQ(faultOf(motion), "");
  for (const int axis : {0, 1, 2})
    for (const double variance : {1e7, 1e12, 1e150, 1.7e308}) {
      motion = goodMotion();
      motion.covariance = Eigen::Matrix3d::Identity();
      motion.covariance(axis, axis) = variance;
      EXPECT_TRUE(test::oneSays({faultOf(motion)}, {"standard deviations", "1000 m", "10 rad"}));
    }
}

TEST(Covariance, AHugeElementOnOneSideOfTheDiagonalIsNone) {
  for (const double value : {1e300, 1e9, 1.0, 1e-3}) {
    Eigen::Matrix3d matrix = 1e-4 * Eigen::Matrix3d::Identity();
    matrix(0, 2) = value;
    EXPECT_FALSE(isCovariance(matrix)) << value;
    EXPECT_FALSE(isCovariance(matrix.transpose())) << value;
  }
}

TEST(Covariance, RoundingOfItsElementsIsNoLackOfSymmetry) {
  Eigen::Matrix2d matrix;
  matrix << 1.0, 0.3e-3, 0.3e-3 * (1.0 + 1e-7), 1e-6;
  EXPECT_TRUE(isCovariance(matrix));
}

}  // namespace
}  // namespace slam
