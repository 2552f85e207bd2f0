// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "rawlog_lasers.hpp"
#include "rawlog_log.hpp"
#include "rawlog_maker.hpp"
#include "second.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

template <class Fill>
RawlogLog readMade(Fill fill) {
  TempFolder folder;
  {
    RawlogMaker maker(folder.file("a.rawlog"));
    fill(maker);
  }
  std::ostringstream log;
  Progress progress(log, false);
  return readRawlog(folder.file("a.rawlog"), progress);
}

TEST(RawlogScans, OfActionsAndFramesHaveTheOdometryOfTheirStamp) {
  const RawlogLog log = readMade([](RawlogMaker& maker) {
    maker.frame({RawlogMaker::scan(100.0)});
    maker.action(1.0, 0.0, 0.0);
    maker.frame({RawlogMaker::scan(101.0)});
  });
  ASSERT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(log.scans[1].stamp, 101 * kSecond);
  ASSERT_EQ(log.odometry.size(), 2u);
  EXPECT_EQ(log.odometry[1].stamp, 101 * kSecond);
  EXPECT_EQ(log.odometry[1].x, 1.0);
  EXPECT_EQ(log.other_objects, 0u);
}

TEST(RawlogScans, OfSingleObservationsHaveStampsOfTheirOwn) {
  const RawlogLog log = readMade([](RawlogMaker& maker) {
    maker.odometry(100.0, 0.0, 0.0, 0.0);
    maker.observation(RawlogMaker::scan(100.25));
    maker.odometry(100.5, 1.0, 0.0, 0.0);
  });
  ASSERT_EQ(log.scans.size(), 1u);
  EXPECT_EQ(log.scans[0].stamp, 100 * kSecond + kSecond / 4);
  EXPECT_EQ(log.odometry.size(), 2u);
}

TEST(RawlogScans, RunCounterClockwiseFromTheRight) {
  auto scan = RawlogMaker::scan(100.0);
  const auto reading = *toReading(scan);
  EXPECT_NEAR(reading.start_angle, -M_PI / 2.0, 1e-6);
  EXPECT_NEAR(reading.increment, M_PI / 2.0, 1e-6);
  EXPECT_EQ(reading.ranges[0], 1.0f);
  EXPECT_TRUE(std::isnan(reading.ranges[1])) << "marked as invalid";
  EXPECT_TRUE(std::isinf(reading.ranges[2])) << "beyond the maximum";
  scan.rightToLeft = false;
  const auto mirrored = *toReading(scan);
  EXPECT_EQ(mirrored.ranges[2], 1.0f);
  EXPECT_EQ(mirrored.start_angle, reading.start_angle);
}

TEST(RawlogScans, WithoutBeamsAreLeftOut) {
  EXPECT_FALSE(toReading(mrpt::obs::CObservation2DRangeScan()));
  const RawlogLog log = readMade([](RawlogMaker& maker) {
    maker.odometry(100.0, 0.0, 0.0, 0.0);
    maker.observation(mrpt::obs::CObservation2DRangeScan());
    maker.odometry(101.0, 0.0, 0.0, 0.0);
  });
  EXPECT_EQ(log.left_out_scans, 1u);
  EXPECT_TRUE(log.lasers.empty());
  EXPECT_FALSE(log.main_laser);
}

TEST(RawlogScans, AreThoseOfTheLaserThatLooksAheadMost) {
  const RawlogLog log = readMade([](RawlogMaker& maker) {
    maker.odometry(99.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 3; ++i) {
      maker.observation(RawlogMaker::scan(100.0 + i, "rear", M_PI));
      if (i < 2) maker.observation(RawlogMaker::scan(100.5 + i, "front", 0.01));
    }
    maker.odometry(103.0, 0.0, 0.0, 0.0);
  });
  ASSERT_EQ(log.lasers.size(), 2u);
  EXPECT_EQ(log.lasers[*log.main_laser].label, "front");
  EXPECT_EQ(log.lasers[0].scans, 3u);
  EXPECT_EQ(log.scans.size(), 2u);
}

TEST(RawlogScans, OfATiltedLaserCountOnlyWhereThereIsNoLevelOne) {
  RawlogLog::Laser level, tilted, upside_down;
  level.yaw = 2.0;
  tilted.pitch = 0.5;
  upside_down.yaw = 1.0;
  upside_down.roll = M_PI;
  EXPECT_EQ(mainLaser({tilted}), 0u);
  EXPECT_EQ(mainLaser({tilted, level}), 1u);
  EXPECT_EQ(mainLaser({tilted, level, upside_down}), 2u);
  level.yaw = 1.0;
  level.scans = 5;
  EXPECT_EQ(mainLaser({upside_down, level}), 1u) << "the one with more scans";
  EXPECT_FALSE(mainLaser({}));
}

}  // namespace
}  // namespace slam::eval
