// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/scan_change.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/archive.hpp"
#include "slam_core/relocalisation/test/scan_of_room.hpp"

namespace slam::relocalisation {
namespace {

using slam::test::Room;
using Change = ScanChange::Verdict;

const Room kBigHall{10.0, 8.0}, kNarrowPassage{16.0, 3.0}, kLongLobby{5.0, 20.0};

/// A robot that drives on by a little between scans.
class ScanChangeTest : public testing::Test {
 protected:
  void driveOn(double misturn = 0.0) {
    Motion motion;
    motion.increment = Pose2(0.05, 0.0, 0.02);
    motion.covariance = 1e-5 * Eigen::Matrix3d::Identity();
    change.move(motion);
    robot = robot * motion.increment * Pose2(0.0, 0.0, misturn);
    stamp += interval;
  }
  Change see(const Room& room, double misturn = 0.0) {
    driveOn(misturn);
    return change.judge(laser.scanOf(room, robot, stamp));
  }
  void goOn(int scans) {
    for (int i = 0; i < scans; ++i) ASSERT_EQ(see(kBigHall), Change::kGoesOn) << i;
  }

  ScanChange change;
  Pose2 robot;
  Stamp stamp = stampFromNanoseconds(1000000000000);
  Duration interval = std::chrono::milliseconds(200);
  slam::test::CoarseLaser laser;
};

TEST_F(ScanChangeTest, NoticesAnotherRoomAtTheThirdScan) {
  goOn(20);
  EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
  EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
  EXPECT_EQ(see(kNarrowPassage), Change::kChanged);
  EXPECT_EQ(see(kNarrowPassage), Change::kGoesOn);
}

TEST_F(ScanChangeTest, NoticesItThoughScansWereDamagedOnTheWay) {
  goOn(20);
  EXPECT_EQ(see(kLongLobby), Change::kUnlike);
  EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
  EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
  EXPECT_EQ(see(kNarrowPassage), Change::kChanged);
}

TEST_F(ScanChangeTest, NoticesItByALaserWhoseBearingsBeginAtZero) {
  laser.first = 0.0;
  for (const int seen : {180, 90}) {
    laser.beams = seen;
    change.forget();
    robot = {};
    goOn(5);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(see(kLongLobby), Change::kUnlike) << seen;
    EXPECT_EQ(see(kLongLobby), Change::kChanged) << seen;
  }
}

TEST_F(ScanChangeTest, WaitsForAThirdOfASecondHoweverFastScansCome) {
  interval = std::chrono::milliseconds(25);
  goOn(5);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(see(kNarrowPassage), Change::kUnlike) << i;
  EXPECT_EQ(see(kNarrowPassage), Change::kChanged);
}

TEST_F(ScanChangeTest, DoesNotMindADamagedScan) {
  EXPECT_EQ(see(kNarrowPassage), Change::kGoesOn);
  for (int i = 0; i < 10; ++i) {
    goOn(5);
    EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
  }
}

TEST_F(ScanChangeTest, DoesNotMindSeveralDamagedScans) {
  for (int i = 0; i < 10; ++i) {
    goOn(5);
    EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
    EXPECT_EQ(see(kLongLobby), Change::kUnlike);
    EXPECT_EQ(see(kNarrowPassage), Change::kUnlike);
    EXPECT_EQ(see(kLongLobby), Change::kUnlike);
  }
}

/// A turn changes much of what is seen in a passage.
TEST_F(ScanChangeTest, DoesNotMindOdometryThatMissesATurn) {
  const auto before = laser.scanOf(kNarrowPassage, {}),
             turned = laser.scanOf(kNarrowPassage, {0.0, 0.0, 0.15});
  EXPECT_TRUE(areUnlike(ScanProfile(before), ScanProfile(turned), {}));
  for (const double misturn : {0.13, -0.13}) {
    change.forget();
    for (int i = 0; i < 20; ++i) {
      robot = {};
      EXPECT_EQ(see(kNarrowPassage, i % 2 == 0 ? misturn : 0.0), Change::kGoesOn);
    }
  }
}

/// Somebody hides half of the view at once, and nothing is seen behind him.
TEST_F(ScanChangeTest, DoesNotMindSomebodyBeforeTheLaser) {
  goOn(5);
  for (int i = 0; i < 10; ++i) {
    driveOn();
    auto hidden = laser.scanOf(kBigHall, robot, stamp);
    for (auto& beam : hidden.beams)
      if (beam.bearing > 0.0f) beam.range = 0.5f;
    EXPECT_EQ(change.judge(hidden), Change::kGoesOn);
  }
  goOn(5);
}

TEST_F(ScanChangeTest, DoesNotMindALaserThatIsCovered) {
  goOn(5);
  laser.farthest = 0.1;
  for (int i = 0; i < 3; ++i) {
    driveOn();
    EXPECT_EQ(change.judge(laser.scanOf(kBigHall, robot, stamp)), Change::kGoesOn);
  }
  laser.farthest = 30.0;
  EXPECT_EQ(see(kNarrowPassage), Change::kUnlike) << "the last scan that showed something counts";
}

TEST_F(ScanChangeTest, SaysNothingOfAnotherLaser) {
  goOn(5);
  for (int i = 0; i < 5; ++i) {
    driveOn();
    auto scan = laser.scanOf(kNarrowPassage, robot, stamp);
    scan.sensor_frame = "rear_laser";
    EXPECT_EQ(change.judge(scan), Change::kGoesOn);
  }
}

TEST_F(ScanChangeTest, SaysNothingAfterALongTime) {
  goOn(5);
  stamp += std::chrono::seconds(5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(see(kNarrowPassage), Change::kGoesOn);
}

TEST_F(ScanChangeTest, SaysNothingWithoutMotion) {
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(change.judge(laser.scanOf(kBigHall, {}, stamp)), Change::kGoesOn);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(change.judge(laser.scanOf(kNarrowPassage, {}, stamp)), Change::kGoesOn);
}

TEST_F(ScanChangeTest, SaysNothingWhereOdometryIsUncertain) {
  goOn(5);
  Motion gap;
  gap.covariance = Eigen::Matrix3d::Identity();
  change.move(gap);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(see(kNarrowPassage), Change::kGoesOn);
}

TEST_F(ScanChangeTest, GoesOnInTheMiddleOfAChange) {
  goOn(5);
  see(kNarrowPassage);
  see(kNarrowPassage);
  ArchiveWriter writer;
  writer(change);
  const auto bytes = writer.take();
  change.forget();
  ArchiveReader reader(bytes);
  reader(change);
  EXPECT_EQ(see(kNarrowPassage), Change::kChanged);
}

}  // namespace
}  // namespace slam::relocalisation
