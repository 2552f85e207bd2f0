// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/grid_slam/grid_slam.hpp"
#include "slam_core/product/test/driven_backend.hpp"

namespace slam::grid_slam {
namespace {

using test::DrivenBackend;
using test::RoomDrive;

double distance(const Backend& backend, const Pose2& truth) {
  return (backend.pose().pose.position() - truth.position()).norm();
}

/// A back-end in a room, with what happens to robots.
class GridSlamInARoom : public testing::Test {
 protected:
  /// @param has_motion else scans alone
  RoomDrive::Step step(bool has_motion = true) {
    const auto next = drive.next();
    give(next, has_motion);
    return next;
  }
  void give(const RoomDrive::Step& next, bool has_motion) {
    if (has_motion) backend.inputs().offer(next.motion);
    backend.inputs().set(next.scan);
    status = backend->execute();
  }

  const GridSlam of_library;  // a library that no symbol is named of would not be linked
  RoomDrive drive{1};
  DrivenBackend backend{{"grid", "grid", {}}};
  Status status;
};

TEST_F(GridSlamInARoom, NeedsNoMotion) {
  double worst = 0.0;
  for (int i = 0; i < RoomDrive::kLap; ++i)
    worst = std::max(worst, distance(*backend, step(false).truth));
  EXPECT_TRUE(status.isOk()) << status.message;
  EXPECT_LT(worst, 0.03);
}

TEST_F(GridSlamInARoom, WheelsThatStandStillWhileTheRobotDrivesDoNotHoldIt) {
  for (int i = 0; i < RoomDrive::kLap; ++i) {
    auto next = drive.next();
    if (i > 20) next.motion.increment = Pose2();
    give(next, true);
    ASSERT_LT(distance(*backend, next.truth), 0.05) << "step " << i;
  }
}

TEST_F(GridSlamInARoom, WheelsThatTurnWhileTheRobotStandsDoNotMoveIt) {
  for (int i = 0; i < 60; ++i) step();
  const auto stands = drive.next();
  for (int i = 0; i < 30; ++i) {
    auto next = stands;
    next.motion.increment = Pose2(0.1, 0.0, 0.04);
    next.scan.stamp += i * std::chrono::milliseconds(100);
    if (i == 0) next.motion.increment = stands.motion.increment;
    give(next, true);
  }
  EXPECT_LT(distance(*backend, stands.truth), 0.03);
}

TEST_F(GridSlamInARoom, GoesOnByMotionWhileTheLaserIsBlind) {
  for (int i = 0; i < 40; ++i) step();
  const auto before = backend->pose();
  Pose2 truth;
  for (int i = 0; i < 5; ++i) {
    auto next = drive.next();
    next.scan.beams.clear();
    give(next, true);
    truth = next.truth;
  }
  EXPECT_EQ(backend->counters()["unmatched"], 5u);
  EXPECT_LT(distance(*backend, truth), 0.1);
  EXPECT_GT(backend->pose().covariance(0, 0), before.covariance(0, 0));
  for (int i = 0; i < 3; ++i) truth = step().truth;
  EXPECT_LT(distance(*backend, truth), 0.03);
}

TEST_F(GridSlamInARoom, BeginsItsMapWithTheFirstScanThatTellsSomething) {
  for (int i = 0; i < RoomDrive::kLap; ++i) {
    auto next = drive.next();
    if (i < 10) next.scan.beams.clear();
    give(next, true);
    const double variance = backend->pose().covariance(0, 0);
    ASSERT_TRUE(i != 9 || variance > 1e-4) << "by odometry alone";
  }
  EXPECT_TRUE(status.isOk()) << status.message;
  EXPECT_TRUE(backend.as<GridMapper>().grid()->cells.size() > 1000);
  EXPECT_LT(distance(*backend, drive.next().truth), 0.2);
}

TEST_F(GridSlamInARoom, SaysThatScansHoldNothing) {
  for (int i = 0; i < 40; ++i) step();
  for (int i = 0; i < 12; ++i) {
    auto next = drive.next();
    next.scan.beams.clear();
    give(next, true);
  }
  EXPECT_TRUE(test::oneSays({status.message}, {"no range", "motion alone"})) << status.message;
}

TEST_F(GridSlamInARoom, SaysThatALaserIsBlindFromTheStart) {
  for (int i = 0; i < 12; ++i) {
    auto next = drive.next();
    next.scan.beams.clear();
    give(next, false);
  }
  EXPECT_TRUE(test::oneSays({status.message}, {"no range", "velocity alone"})) << status.message;
}

TEST_F(GridSlamInARoom, TellsThatItIsLostWhereScansContradictTheMap) {
  for (int i = 0; i < RoomDrive::kLap; ++i) step();
  ASSERT_TRUE(status.isOk());
  const auto revision = backend.as<GridMapper>().gridRevision();
  constexpr unsigned kScans = 150;
  for (unsigned i = 0; i < kScans; ++i) {
    auto carried = drive.next();
    for (auto& beam : carried.scan.beams) beam.range = 0.5f;  // a cupboard
    carried.motion.increment = Pose2();
    give(carried, true);
  }
  EXPECT_TRUE(status.is_alarm);
  EXPECT_NE(status.message.find("the pose may be lost"), std::string::npos);
  EXPECT_TRUE(backend.as<LostReporter>().lostSince());
  EXPECT_EQ(backend->counters()["contradicting"], kScans);
  EXPECT_EQ(backend.as<GridMapper>().gridRevision(), revision) << "it does not go into the map";
}

TEST_F(GridSlamInARoom, KeepsALoadedMapWhereItOnlyLocalises) {
  for (int i = 0; i < RoomDrive::kLap; ++i) step();
  DrivenBackend localising({"grid", "grid", {"grid.mode=localization"}});
  localising.as<MapKeeper>().set(backend.as<MapKeeper>().state());
  localising.execute();
  const auto cells = localising.as<GridMapper>().grid()->cells;
  Pose2 truth;
  for (int i = 0; i < 40; ++i) {
    const auto next = drive.next();
    localising.inputs().set(next.scan);
    localising.execute();
    truth = next.truth;
  }
  EXPECT_LT(distance(*localising, truth), 0.05);
  EXPECT_EQ(localising->counters()["unmatched"], 0u);
  EXPECT_LT(std::sqrt(localising->pose().covariance(0, 0)), 0.05);
  EXPECT_EQ(localising.as<GridMapper>().grid()->cells, cells);
}

TEST_F(GridSlamInARoom, TellsThatItIsLostInALoadedMapUntilItGetsItsPlace) {
  for (int i = 0; i < RoomDrive::kLap; ++i) step();
  DrivenBackend localising({"grid", "grid", {"grid.mode=localization"}});
  localising.as<MapKeeper>().set(backend.as<MapKeeper>().state());
  localising->execute();
  const auto follow = [&](int steps, bool has_motion) {
    int alarms = 0;
    for (int i = 0; i < steps; ++i) {
      const auto next = drive.next();
      if (has_motion) localising.inputs().offer(next.motion);
      localising.inputs().set(next.scan);
      alarms += localising->execute().is_alarm;
    }
    return alarms;
  };
  EXPECT_EQ(follow(40, true), 0);
  for (int i = 0; i < 40; ++i) drive.next();  // carried
  EXPECT_GT(follow(50, true), 0) << "within 5 m";
  EXPECT_TRUE(localising.as<LostReporter>().lostSince());
  localising->set(PoseEstimate{drive.next().truth, 1e-4 * Eigen::Matrix3d::Identity()});
  EXPECT_EQ(follow(40, true), 0);
}

/// A robot beside a loaded map sees nothing that contradicts it.
TEST_F(GridSlamInARoom, TellsThatItIsLostBesideALoadedMap) {
  for (int i = 0; i < RoomDrive::kLap; ++i) step();
  DrivenBackend localising({"grid", "grid", {"grid.mode=localization"}});
  localising.as<MapKeeper>().set(backend.as<MapKeeper>().state());
  localising->set(PoseEstimate{Pose2(200.0, 0.0, 0.0), 1e-4 * Eigen::Matrix3d::Identity()});
  localising->execute();
  Status told;
  for (int i = 0; i < 80; ++i) {
    const auto next = drive.next();
    localising.inputs().offer(next.motion);
    localising.inputs().set(next.scan);
    told = localising->execute();
  }
  EXPECT_TRUE(told.is_alarm) << told.message;
  EXPECT_TRUE(localising.as<LostReporter>().lostSince());
}

TEST_F(GridSlamInARoom, SaysThatItHasNoMapToLocaliseIn) {
  DrivenBackend localising({"grid", "grid", {"grid.mode=localization"}});
  localising.inputs().set(drive.next().scan);
  const auto told = localising->execute();
  EXPECT_NE(told.message.find("no map to localise in"), std::string::npos);
}

TEST_F(GridSlamInARoom, SaysWhenThereIsNotEnoughMemoryAndKeepsTheMap) {
  DrivenBackend small({"grid", "grid", {"grid_map.largest_memory=0.5"}});
  Status told;
  Pose2 truth;
  for (int i = 0; i < RoomDrive::kLap; ++i) {
    const auto next = drive.next();
    truth = next.truth;
    small.inputs().offer(next.motion);
    small.inputs().set(next.scan);
    if (const auto step = small->execute(); !step.isOk()) told = step;
  }
  EXPECT_NE(told.message.find("grid_map.largest_memory"), std::string::npos) << told.message;
  EXPECT_FALSE(small.as<GridMapper>().grid()->cells.empty());
  EXPECT_LT(distance(*small, truth), 0.5) << "it goes on with what it has";
}

TEST_F(GridSlamInARoom, RefusesAMapWithoutAGrid) {
  for (int i = 0; i < 20; ++i) step();
  const auto before = backend->pose();
  backend.as<MapKeeper>().set(MapState{{Pose2(9, 9, 0), Eigen::Matrix3d::Identity()}, {}, {}});
  EXPECT_EQ(backend->execute().level, Status::Level::kError);
  EXPECT_EQ(backend->pose().pose.vector(), before.pose.vector());
}

}  // namespace
}  // namespace slam::grid_slam
