// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/memory/shared_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::particle_filter {
namespace {

const Pose2 kStride(1.0, 0.0, 0.0);

Stamp stamp(int i) { return stampFromNanoseconds(i); }

TEST(SharedPath, SharesWhatItHasInCommonAndForgetsWhatNobodyDescendsFrom) {
  SharedPath::Memory memory;
  SharedPath trunk(memory);
  const auto step = [&](int i) { memory.addStep(stamp(i), kStride); };
  for (int i = 0; i < 100; ++i) {
    step(i);
    trunk.append(Pose2(i, 0, 0));
  }
  {
    std::vector<SharedPath> branches(10, trunk);
    for (int i = 100; i < 110; ++i) {
      step(i);
      for (auto& branch : branches) branch.append(Pose2(i, 0, 0));
    }
    EXPECT_EQ(memory.posesInUse(), 200u);
    trunk = branches[3];
    const auto poses = trunk.poses(Pose2());
    ASSERT_EQ(poses.size(), 110u);
    for (int i = 0; i < 110; ++i) {
      EXPECT_EQ(nanoseconds(poses[std::size_t(i)].stamp), i);
      EXPECT_EQ(poses[std::size_t(i)].pose.x(), i);
    }
  }
  EXPECT_EQ(memory.posesInUse(), 110u);
  trunk = SharedPath(memory);
  EXPECT_EQ(memory.posesInUse(), 0u);
}

TEST(SharedPath, HoldsNothingOfStepsThatTaughtNothing) {
  SharedPath::Memory memory;
  std::vector<SharedPath> paths(50, SharedPath(memory));
  for (int i = 0; i < 1000; ++i) memory.addStep(stamp(i), kStride);
  EXPECT_EQ(memory.posesInUse(), 0u);
  const auto poses = paths[7].poses(Pose2(500.0, 0.0, 0.0));
  ASSERT_EQ(poses.size(), 1000u);
  EXPECT_DOUBLE_EQ(poses.front().pose.x(), 500.0 - 999.0) << "as the odometry says, back from now";
}

TEST(SharedPath, FollowsTheOdometryBetweenWhatItHolds) {
  SharedPath::Memory memory;
  SharedPath path(memory);
  const Pose2 turn(0.0, 0.0, M_PI / 2);
  memory.addStep(stamp(0), Pose2());
  path.append(Pose2());
  memory.addStep(stamp(1), kStride);
  memory.addStep(stamp(2), turn);
  memory.addStep(stamp(3), kStride);
  memory.addStep(stamp(4), kStride);
  path.append(Pose2(1.0, 2.4, M_PI / 2));  // it was 0.4 m further along than the odometry says
  const auto poses = path.poses(Pose2());
  ASSERT_EQ(poses.size(), 5u);
  EXPECT_EQ(poses.back().pose.vector(), Pose2(1.0, 2.4, M_PI / 2).vector());
  EXPECT_NEAR(poses[1].pose.x(), 1.1, 1e-12) << "a quarter of the error, in the robot's frame";
  EXPECT_NEAR(poses[3].pose.y(), 1.0 + 0.3, 1e-12);
  EXPECT_NEAR(poses[3].pose.x(), 1.0, 1e-12);
}

TEST(SharedPath, EndsWhereTheParticleIsNow) {
  SharedPath::Memory memory;
  SharedPath path(memory);
  memory.addStep(stamp(0), Pose2());
  path.append(Pose2());
  memory.addStep(stamp(1), kStride);
  memory.addStep(stamp(2), kStride);
  const auto poses = path.poses(Pose2(2.2, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(poses[1].pose.x(), 1.1);
  EXPECT_DOUBLE_EQ(poses[2].pose.x(), 2.2);
}

TEST(SharedPath, OfAnyLengthIsForgottenWithoutRecursion) {
  SharedPath::Memory memory;
  {
    SharedPath path(memory);
    for (int i = 0; i < 2000000; ++i) {
      memory.addStep(stamp(i), Pose2());
      path.append({});
    }
  }
  EXPECT_EQ(memory.posesInUse(), 0u);
}

}  // namespace
}  // namespace slam::particle_filter
