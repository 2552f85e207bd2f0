// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <utility>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/particle_filter/test/filter_in_a_room.hpp"

namespace slam::particle_filter {
namespace {

TEST(LostOnAGrid, StaysOnTheMapWhereWheelsSlip) {
  const auto filter = made();
  RoomDrive drive(3);
  for (int i = 0; i < kLap; ++i) {
    auto step = drive.next();
    if (i == 70) step.motion.increment = step.motion.increment * Pose2(0.0, 0.0, 0.3);
    if (i == 100) step.motion.increment = step.motion.increment * Pose2(0.2, 0.0, 0.0);
    EXPECT_EQ(take(*filter, step).message, "");
    EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
    EXPECT_LT(std::abs(filter->pose().pose.between(step.truth).theta()), 0.05) << i;
  }
}

TEST(LostOnAGrid, StaysOnTheMapWhereOdometryFreezesAndThenJumps) {
  const auto filter = made();
  RoomDrive drive(4);
  Pose2 held;
  for (int i = 0; i < kLap; ++i) {
    auto step = drive.next();
    held = held * step.motion.increment;
    const bool is_frozen = i >= 60 && i < 66;
    step.motion.increment = is_frozen ? Pose2() : std::exchange(held, Pose2());
    take(*filter, step);
    EXPECT_LT((filter->pose().pose.position() - step.truth.position()).norm(), 0.1) << i;
  }
}

/// @return in how many steps the filter said that the pose may be lost
int countLost(FastSlam& filter, RoomDrive& drive, int steps) {
  int lost = 0;
  for (int i = 0; i < steps; ++i)
    lost += test::oneSays({take(filter, drive.next()).message}, {"may be lost", "initial pose"});
  return lost;
}

TEST(LostOnAGrid, ARobotCarriedAwayWhileItMapsIsReportedLostOrFoundAgain) {
  for (const int carried : {20, 30, 40, 50, 90, 100, 110}) {  // the far side looks alike
    const auto filter = made();
    RoomDrive drive(20);
    EXPECT_EQ(countLost(*filter, drive, 2 * kLap), 0);
    for (int i = 0; i < carried; ++i) drive.next();
    const int lost = countLost(*filter, drive, 10);
    const auto step = drive.next();
    take(*filter, step);
    const double error = (filter->pose().pose.position() - step.truth.position()).norm();
    EXPECT_TRUE(lost > 0 || error < 0.2) << carried << " steps: " << error << " m off";
  }
}

TEST(LostOnAGrid, ARobotCarriedToAPlaceThatLooksAlikeIsReportedWithinFiveMetres) {
  for (const int carried : {60, 70}) {
    const auto filter = made();
    RoomDrive drive(20);
    EXPECT_EQ(countLost(*filter, drive, 2 * kLap), 0);
    for (int i = 0; i < carried; ++i) drive.next();
    EXPECT_GT(countLost(*filter, drive, 50), 0) << carried;
  }
}

TEST(LostOnAGrid, ARobotCarriedAwayInAFixedMapIsFoundAgainOrReportedLostUntilItGetsANewPose) {
  const auto mapper = made();
  RoomDrive first(21);
  run(*mapper, first, kLap);
  auto config = gridConfig();
  config.mode = BackendMode::kLocalization;
  for (const int carried : {30, 60, 90}) {
    const auto filter = made(config);
    as<MapKeeper>(*filter).set(as<MapKeeper>(*mapper).state());
    RoomDrive drive(22);
    filter->set(PoseEstimate{Pose2(), 1e-3 * Eigen::Matrix3d::Identity()});
    EXPECT_EQ(countLost(*filter, drive, 40), 0);
    for (int i = 0; i < carried; ++i) drive.next();
    const int lost = countLost(*filter, drive, 30);
    auto step = drive.next();
    take(*filter, step);
    const double error = (filter->pose().pose.position() - step.truth.position()).norm();
    EXPECT_TRUE(lost > 5 || error < 0.2) << carried << " steps: " << error << " m off";
    step = drive.next();
    filter->set(PoseEstimate{step.truth, 1e-3 * Eigen::Matrix3d::Identity()});
    take(*filter, step);
    EXPECT_EQ(countLost(*filter, drive, 40), 0);
  }
}

}  // namespace
}  // namespace slam::particle_filter
