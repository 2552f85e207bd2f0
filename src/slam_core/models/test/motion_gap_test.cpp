// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_gap.hpp"

#include <gtest/gtest.h>

#include "slam_core/models/test/simulated_world.hpp"

namespace slam {
namespace {

std::vector<Motion> drive(int steps) {
  test::SimulatedWorld world(1);
  std::vector<Motion> all;
  for (int i = 0; i < steps; ++i) all.push_back(world.next().motion);
  return all;
}

TEST(MotionGap, LeavesAloneWhatIsComplete) {
  MotionGap gap;
  for (auto motion : drive(10)) {
    const auto start = motion.start;
    EXPECT_FALSE(gap.bridge(motion));
    EXPECT_EQ(motion.start, start);
  }
}

TEST(MotionGap, IsBridgedByWhatTheLostMotionsTellTogether) {
  const auto all = drive(60);
  MotionGap gap;
  auto first = all[4], next = all[55];
  EXPECT_FALSE(gap.bridge(first));
  ASSERT_TRUE(gap.bridge(next));
  Motion expected = all[5];
  for (int i = 6; i <= 55; ++i) expected = joined(expected, all[i]);
  EXPECT_EQ(next.start, expected.start);
  EXPECT_EQ(next.end, expected.end);
  EXPECT_EQ(next.sequence, 55u);
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-9);
  EXPECT_LT((next.odometry_start.vector() - expected.odometry_start.vector()).norm(), 1e-9);
  // the robot's speed and noise are constant, so that its worst increment is like all others
  EXPECT_TRUE(next.covariance.isApprox(expected.covariance, 1e-6)) << next.covariance;
}

TEST(MotionGap, IsAsUncertainAsTheWorstIncrementThatWasSeen) {
  auto all = drive(20);
  all[2].covariance *= 9.0;
  MotionGap gap;
  for (int i : {0, 1, 2, 3}) gap.bridge(all[i]);
  Motion next = all[14];
  ASSERT_TRUE(gap.bridge(next));
  EXPECT_GT(next.covariance(0, 0), 9.0 * 10 * all[0].covariance(0, 0));
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, IsAsUncertainAsTheWorstWayAndTheWorstTurn) {
  auto all = drive(20);
  all[1].covariance.topLeftCorner<2, 2>() *= 9.0;
  all[2].covariance(2, 2) *= 9.0;  // [rad^2], not to be weighed up with [m^2]
  MotionGap gap;
  for (int i : {0, 1, 2, 3}) gap.bridge(all[i]);
  Motion next = all[14];
  ASSERT_TRUE(gap.bridge(next));
  EXPECT_GT(next.covariance(0, 0), 9.0 * 10 * all[0].covariance(0, 0));
  EXPECT_GT(next.covariance(2, 2), 9.0 * 10 * all[0].covariance(2, 2));
  EXPECT_EQ(faultOf(next), "");
}

/// The increments of a drive, one of them in two parts of which the first is of a millisecond and
/// has more than its part of the covariance: what an odometry adds to each increment.
std::vector<Motion> driveWithAShortIncrement() {
  auto all = drive(20);
  auto [first, second] = split(all[2], all[2].start + std::chrono::milliseconds(1));
  first.covariance = 0.1 * all[2].covariance;
  all[2] = first;
  all.insert(all.begin() + 3, second);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].sequence = i;
  return all;
}

TEST(MotionGap, IsNotAsUncertainAsAShortIncrementSeemsToTell) {
  const auto covarianceAfter = [](const std::vector<Motion>& all) {
    MotionGap gap;
    for (std::size_t i = 0; i < 5; ++i) {
      auto motion = all[i];
      EXPECT_FALSE(gap.bridge(motion));
    }
    auto next = all.back();
    EXPECT_TRUE(gap.bridge(next));
    return next.covariance;
  };
  const auto covariance = covarianceAfter(driveWithAShortIncrement());
  EXPECT_LT(covariance.trace(), 1.5 * covarianceAfter(drive(20)).trace());
}

TEST(MotionGap, IsBridgedAtOnceByWhatAShortIncrementTells) {
  const auto all = driveWithAShortIncrement();
  MotionGap gap;
  auto first = all[2], next = all[12];
  gap.bridge(first);
  ASSERT_TRUE(gap.bridge(next));
  EXPECT_EQ(faultOf(next), "");
}

TEST(MotionGap, OfWheelsThatAreCalibratedIsBridgedWithTheirScales) {
  auto all = drive(60);
  for (auto& motion : all) {
    Eigen::Vector3d twist = motion.increment.log();
    twist.head<2>() *= 1.05;
    twist.z() *= 0.9;
    motion.increment = Pose2::exp(twist);  // odometry's poses stay as they were measured
  }
  MotionGap gap;
  for (std::size_t i = 0; i < 5; ++i) gap.bridge(all[i]);
  Motion next = all[40], expected = all[5];
  ASSERT_TRUE(gap.bridge(next));
  for (int i = 6; i <= 40; ++i) expected = joined(expected, all[i]);
  EXPECT_LT((next.increment.vector() - expected.increment.vector()).norm(), 1e-5);
}

TEST(MotionGap, IsNotSeenWhereAMotionComesLate) {
  const auto all = drive(10);
  MotionGap gap;
  for (int i : {0, 1, 2, 3, 1, 4, 3, 5}) {
    Motion next = all[i];
    EXPECT_FALSE(gap.bridge(next)) << i;
  }
}

TEST(MotionGap, OfAnOdometryThatBeganAnewIsNone) {
  const auto all = drive(20);
  MotionGap gap;
  Motion next = all[0];
  gap.bridge(next);
  next = all[10];
  next.sequence = 0;
  EXPECT_FALSE(gap.bridge(next)) << "its first message";
  next = all[15];
  next.odometry_frame = "visual_odom";
  EXPECT_FALSE(gap.bridge(next)) << "another odometry";
  gap.reset();
  next = all[19];
  EXPECT_FALSE(gap.bridge(next)) << "the first after a reset";
}

}  // namespace
}  // namespace slam
