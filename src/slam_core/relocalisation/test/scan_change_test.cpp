// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/scan_change.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/archive.hpp"
#include "slam_core/relocalisation/test/scan_of_room.hpp"

namespace slam::relocalisation {
namespace {

using test::EmptyRoom;
using Verdict = ScanChange::Verdict;

const EmptyRoom kHall{10.0, 8.0}, kPassage{16.0, 3.0};

/// A robot that drives on by a little between scans.
class ScanChangeTest : public testing::Test {
 protected:
  static constexpr double kStep = 0.05;  // [m]

  Verdict see(const EmptyRoom& room, double misturn = 0.0) {
    Motion motion;
    motion.increment = Pose2(kStep, 0.0, 0.02);
    motion.covariance = 1e-5 * Eigen::Matrix3d::Identity();
    change.move(motion);
    robot = robot * motion.increment * Pose2(0.0, 0.0, misturn);
    return change.judge(room.scanFrom(robot));
  }
  void goOn(int scans) {
    for (int i = 0; i < scans; ++i) ASSERT_EQ(see(kHall), Verdict::kGoesOn) << i;
  }

  ScanChange change;
  Pose2 robot;
};

TEST_F(ScanChangeTest, NoticesAnotherRoomAtTheThirdScan) {
  goOn(20);
  EXPECT_EQ(see(kPassage), Verdict::kUnlike);
  EXPECT_EQ(see(kPassage), Verdict::kUnlike);
  EXPECT_EQ(see(kPassage), Verdict::kChanged);
  EXPECT_EQ(see(kPassage), Verdict::kGoesOn);
}

TEST_F(ScanChangeTest, DoesNotMindADamagedScan) {
  for (int i = 0; i < 10; ++i) {
    goOn(5);
    EXPECT_EQ(see(kPassage), Verdict::kUnlike);
  }
}

TEST_F(ScanChangeTest, DoesNotMindScansThatAreAllUnlikeEachOther) {
  goOn(5);
  for (int i = 0; i < 20; ++i) EXPECT_NE(see(i % 2 == 0 ? kPassage : kHall), Verdict::kChanged);
}

TEST_F(ScanChangeTest, DoesNotMindOdometryThatMissesATurn) {
  for (int i = 0; i < 60; ++i) EXPECT_EQ(see(kHall, 0.12), Verdict::kGoesOn);
}

/// Half of the view is hidden at once, and nothing is seen behind it.
TEST_F(ScanChangeTest, DoesNotMindSomebodyBeforeTheLaser) {
  goOn(5);
  auto hidden = kHall.scanFrom(robot);
  for (auto& beam : hidden.beams)
    if (beam.bearing > 0.0f) beam.range = 0.5f;
  change.move(Motion());
  for (int i = 0; i < 5; ++i) EXPECT_EQ(change.judge(hidden), Verdict::kGoesOn);
  goOn(5);
}

TEST_F(ScanChangeTest, SaysNothingWithoutMotion) {
  EXPECT_EQ(change.judge(kHall.scanFrom({})), Verdict::kGoesOn);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(change.judge(kPassage.scanFrom({})), Verdict::kGoesOn);
}

TEST_F(ScanChangeTest, SaysNothingWhereOdometryIsUncertain) {
  goOn(5);
  Motion gap;
  gap.covariance = Eigen::Matrix3d::Identity();
  change.move(gap);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(see(kPassage), Verdict::kGoesOn);
}

TEST_F(ScanChangeTest, GoesOnInTheMiddleOfAChange) {
  goOn(5);
  see(kPassage);
  ArchiveWriter writer;
  writer(change);
  const auto bytes = writer.take();
  change.forget();
  ArchiveReader reader(bytes);
  reader(change);
  EXPECT_EQ(see(kPassage), Verdict::kUnlike);
  EXPECT_EQ(see(kPassage), Verdict::kChanged);
}

}  // namespace
}  // namespace slam::relocalisation
