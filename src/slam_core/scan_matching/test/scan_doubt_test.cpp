// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_doubt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::scan_matching {
namespace {

constexpr int kEnds = 300;

/// A robot that drives straight on, a step for each scan.
class DoubtfulDrive {
 public:
  explicit DoubtfulDrive(double hours = 1000.0, std::uint64_t seed = 1)
      : doubt(0.5, hours), random_(seed, 0) {}

  /// @param share of the ends that contradict the map @param step way to the next scan [m]
  void scan(double share, double step = 0.1) {
    Match match;
    match.is_determined = true;
    way_ += step;
    match.pose = Pose2(way_, 0.0, 0.0);
    match.agreement.contradicting = static_cast<int>(std::lround(share * kEnds));
    match.agreement.agreeing = kEnds - match.agreement.contradicting;
    match.agreement.silent = silent;
    match.jumped = std::exchange(jump, std::nullopt);
    stamp_ += std::chrono::milliseconds(100);
    doubt.judge(match, stamp_);
  }
  void scans(int count, double share, double step = 0.1) {
    for (int i = 0; i < count; ++i) scan(share, step);
  }
  /// Of a share that is beta-distributed: the ratio of gamma-distributed numbers, which for whole
  /// shapes are sums of exponential ones.
  double betaShare(int contradicting, int agreeing) {
    const auto gamma = [this](int shape) {
      double sum = 0.0;
      for (int i = 0; i < shape; ++i) sum -= std::log(1.0 - random_.uniform());
      return sum;
    };
    const double a = gamma(contradicting), b = gamma(agreeing);
    return a / (a + b);
  }
  double way() const { return way_; }
  Stamp stamp() const { return stamp_; }

  ScanDoubt doubt;
  std::optional<Pose2> jump;  ///< of the next scan
  int silent = 0;             ///< ends of each scan where the map knows nothing

 private:
  RandomStream random_;
  double way_ = 0.0;
  Stamp stamp_ = stampFromNanoseconds(0);
};

/// Independent scans whose share is as the statistic takes it to be. With a threshold for one false
/// alarm in 0.1 h, which are 360 of them, 36000 have 100 at most.
TEST(ScanDoubt, RaisesNoMoreFalseAlarmsThanItIsAllowedTo) {
  int alarms = 0;
  DoubtfulDrive drive(0.1);
  for (int i = 0; i < 36000; ++i) {
    drive.scan(drive.betaShare(1, 12), 1.0);
    if (!drive.doubt.isLost()) continue;
    ++alarms;
    drive.doubt.forget();
  }
  EXPECT_LE(alarms, 100);
  EXPECT_GT(alarms, 0) << "the test could not fail";
}

TEST(ScanDoubt, IsLostAtOnceWhereTheRobotMayBeAnywhere) {
  DoubtfulDrive drive;
  drive.scans(20, 0.02);
  drive.scans(4, 0.3);
  ASSERT_GT(drive.doubt.statistic(), 0.0);
  Match anywhere;
  anywhere.is_anywhere = true;
  const auto stamp = drive.stamp() + std::chrono::seconds(12);
  drive.doubt.judge(anywhere, stamp);
  EXPECT_TRUE(drive.doubt.isLost());
  EXPECT_FALSE(drive.doubt.admits());
  EXPECT_NE(drive.doubt.status().message.find("may be anywhere around"), std::string::npos);
  drive.doubt.forget();
  EXPECT_TRUE(drive.doubt.status().isOk());
}

TEST(ScanDoubt, BelievesABuildingWhereASixthOfEachScanContradicts) {
  DoubtfulDrive drive;
  for (int i = 0; i < 20000; ++i) {
    drive.scan(drive.betaShare(3, 15), 0.5);
    ASSERT_FALSE(drive.doubt.isLost()) << i;
  }
}

TEST(ScanDoubt, TellsARobotInAWrongPlaceWithinFiveMetres) {
  for (const double share : {0.3, 0.4, 0.6, 0.9})
    for (const double usual : {0.0, 0.03, 0.06}) {
      DoubtfulDrive drive;
      drive.scans(500, usual);
      ASSERT_FALSE(drive.doubt.isLost());
      const double before = drive.way();
      const auto last = drive.stamp();
      while (!drive.doubt.isLost() && drive.way() < before + 10.0) drive.scan(share);
      EXPECT_LT(drive.way() - before, 5.0) << share << " instead of " << usual;
      ASSERT_TRUE(drive.doubt.isLost());
      EXPECT_EQ(*drive.doubt.lostSince(), last + std::chrono::milliseconds(100));
      EXPECT_EQ(drive.doubt.lostFor(), drive.stamp() - *drive.doubt.lostSince());
    }
}

TEST(ScanDoubt, TellsARobotThatStandsWhereItWasCarried) {
  DoubtfulDrive drive;
  drive.scans(500, 0.03);
  int scans = 0;
  while (!drive.doubt.isLost() && ++scans < 1000) drive.scan(0.7, 0.0);
  EXPECT_LT(scans, 200) << "20 s";
  EXPECT_GT(scans, 10) << "people may stand around for a second";
}

TEST(ScanDoubt, OneScanAloneIsNoAlarmHoweverManyFollowFromTheSamePlace) {
  DoubtfulDrive drive;
  drive.scans(500, 0.03);
  drive.scans(10, 1.0, 0.0);
  EXPECT_FALSE(drive.doubt.isLost());
  EXPECT_GT(drive.doubt.statistic(), 0.0);
}

TEST(ScanDoubt, GetsUsedToAPartOfABuildingThatDiffersMoreAndMore) {
  DoubtfulDrive drive;
  for (int i = 0; i < 400; ++i) {
    drive.scan(0.03 + 0.25 * i / 400.0, 0.5);
    ASSERT_FALSE(drive.doubt.isLost()) << i;
  }
}

TEST(ScanDoubt, TakesTheAlarmBackWhenTheScansFitAgain) {
  DoubtfulDrive drive;
  drive.scans(500, 0.03);
  drive.scans(100, 0.6);
  ASSERT_TRUE(drive.doubt.isLost());
  const double before = drive.way();
  while (drive.doubt.isLost() && drive.way() < before + 100.0) drive.scan(0.03);
  EXPECT_LT(drive.way() - before, 10.0);
  EXPECT_GT(drive.way() - before, 1.0);
  EXPECT_TRUE(drive.doubt.status().isOk());
}

TEST(ScanDoubt, ANewPlaceEndsTheAlarmAtOnce) {
  DoubtfulDrive drive;
  drive.scans(100, 0.8);
  ASSERT_TRUE(drive.doubt.isLost());
  drive.doubt.forget();
  EXPECT_FALSE(drive.doubt.isLost());
  EXPECT_EQ(drive.doubt.statistic(), 0.0);
  EXPECT_EQ(drive.doubt.lostFor(), Duration::zero());
}

TEST(ScanDoubt, KeepsOutWhatContradictsAndWhileLostAllScans) {
  DoubtfulDrive drive;
  drive.scans(200, 0.03);
  drive.scan(0.45);
  EXPECT_TRUE(drive.doubt.admits());
  drive.scan(0.55);
  EXPECT_FALSE(drive.doubt.admits());
  drive.scans(100, 0.6);
  ASSERT_TRUE(drive.doubt.isLost());
  drive.scan(0.03);
  EXPECT_FALSE(drive.doubt.admits());
  drive.scans(300, 0.03);
  ASSERT_FALSE(drive.doubt.isLost());
  EXPECT_TRUE(drive.doubt.admits());
}

TEST(ScanDoubt, IsNotEndedAtTheEdgeOfTheMap) {
  DoubtfulDrive drive;
  drive.scans(200, 0.03);
  drive.scans(100, 0.6);
  ASSERT_TRUE(drive.doubt.isLost());
  const double before = drive.doubt.statistic();
  drive.silent = kEnds + 1;
  drive.scans(300, 0.0);
  EXPECT_EQ(drive.doubt.statistic(), before);
  drive.silent = kEnds;
  drive.scans(300, 0.0);
  EXPECT_FALSE(drive.doubt.isLost());
}

TEST(ScanDoubt, AScanOfUnknownPartsSaysNothing) {
  ScanDoubt doubt;
  Match unknown;
  for (int i = 0; i < 1000; ++i) {
    unknown.pose = Pose2(i, 0, 0);
    doubt.judge(unknown, stampFromNanoseconds(i));
  }
  EXPECT_EQ(doubt.statistic(), 0.0);
  EXPECT_TRUE(doubt.admits());
}

TEST(ScanDoubt, WarnsOfAJumpAndIsSoonerInDoubtAfterIt) {
  DoubtfulDrive drive, carried;
  drive.scans(200, 0.03);
  carried.scans(200, 0.03);
  carried.jump = Pose2(1.1, 0.0, 0.5);
  carried.scan(0.03);
  EXPECT_EQ(carried.doubt.status().level, Status::Level::kWarning);
  EXPECT_FALSE(carried.doubt.status().is_alarm);
  EXPECT_NE(carried.doubt.status().message.find("1.1 m and 29 degrees"), std::string::npos);
  const auto scansUntilLost = [](DoubtfulDrive& of) {
    int scans = 0;
    while (!of.doubt.isLost() && ++scans < 1000) of.scan(0.4);
    return scans;
  };
  EXPECT_LT(scansUntilLost(carried), scansUntilLost(drive));
}

TEST(ScanDoubt, SaysSinceWhenAndWhatToDo) {
  DoubtfulDrive drive;
  drive.scans(20, 0.03);
  drive.scans(50, 0.9);
  const auto status = drive.doubt.status();
  EXPECT_TRUE(status.is_alarm);
  EXPECT_NE(status.message.find("since 2.1 s"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("set an initial pose"), std::string::npos);
}

}  // namespace
}  // namespace slam::scan_matching
