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
