// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/models/test/simulated_room.hpp"

namespace slam::scan_matching {
namespace {

constexpr double kTrackedSpacing = 0.02;
constexpr Duration kInterval = std::chrono::milliseconds(100);

/// A robot in a room that has been mapped.
class TrackedRobot : public testing::Test {
 protected:
  TrackedRobot() {
    for (int i = 0; i < test::RoomDrive::kLap; ++i) {
      last = drive.next();
      map.insert(pointsOf(last.scan, models, kTrackedSpacing), last.truth);
    }
    tracker.restart({last.truth, 1e-6 * Eigen::Matrix3d::Identity()});
    stamp = last.scan.stamp;
  }

  /// @param is_blind without any beam
  void scan(LaserScan seen, bool is_blind = false) {
    if (is_blind) seen.beams.clear();
    stamp += kInterval;
    tracker.track(map.view(), pointsOf(seen, models, kTrackedSpacing), stamp, std::nullopt);
  }
  double error() const { return (tracker.robot().pose.position() - last.truth.position()).norm(); }

  test::RoomDrive drive{3};
  test::RoomDrive::Step last;
  LevelModels models = levelModels({});
  ScanMap map{grid_map::GridMapConfig()};
  ScanTracker tracker;
  Stamp stamp;
};

TEST_F(TrackedRobot, WhatAScanCorrectsAfterBlindOnesIsNotTakenForSpeed) {
  for (int i = 0; i < 3; ++i) scan(last.scan);      // it stands
  for (int i = 0; i < 3; ++i) last = drive.next();  // too little for a wide search
  for (int i = 0; i < 10; ++i) scan(last.scan, true);
  scan(last.scan);
  ASSERT_LT(error(), 0.03);
  const Pose2 before = tracker.robot().pose;
  scan(last.scan, true);
  EXPECT_LT(before.between(tracker.robot().pose).position().norm(), 0.02) << "it stands again";
}

TEST_F(TrackedRobot, MayBeAnywhereAfterAGapInOdometry) {
  const auto after = [&](double sigma) {
    Motion gap;
    gap.increment = Pose2(0.1, 0.1, 0.0);
    gap.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
    stamp += std::chrono::seconds(12);
    return tracker.track(map.view(), pointsOf(last.scan, models, kTrackedSpacing), stamp, gap);
  };
  EXPECT_TRUE(after(0.3).is_determined);
  EXPECT_LT(error(), 0.03);
  const auto lost = after(1.5);
  EXPECT_TRUE(lost.is_anywhere);
  EXPECT_FALSE(lost.is_determined);
  EXPECT_GT(tracker.robot().covariance(0, 0), 2.0);
  EXPECT_TRUE(after(0.01).is_anywhere) << "another place might look like the true one";
  EXPECT_GT(tracker.robot().covariance(0, 0), 2.0);
  tracker.restart({last.truth, 9.0 * Eigen::Matrix3d::Identity()});
  EXPECT_TRUE(after(0.01).is_determined) << "somebody has put it there, however uncertain";
  EXPECT_LT(error(), 0.03);
}

TEST_F(TrackedRobot, AVelocityStaysBelowWhatTheRobotCanDo) {
  MotionLimits limits;
  limits.speed = 0.3;
  tracker = ScanTracker(MatcherConfig(), limits);
  tracker.restart({last.truth, 1e-6 * Eigen::Matrix3d::Identity()});
  for (int i = 0; i < 20; ++i) {
    last = drive.next();
    scan(last.scan);
  }
  ASSERT_LT(error(), 0.03);
  const Pose2 before = tracker.robot().pose;
  scan(last.scan, true);
  EXPECT_LT(before.between(tracker.robot().pose).position().norm(),
            0.3 * std::sqrt(2.0) * 0.1 + 1e-6);
}

TEST_F(TrackedRobot, IsFoundFarAwayOnlyWhereItMayJump) {
  for (const bool may_jump : {true, false}) {
    MotionLimits limits;
    limits.may_jump = may_jump;
    tracker = ScanTracker(MatcherConfig(), limits);
    tracker.restart({last.truth * Pose2(1.5, 0.3, 0.5), 1e-6 * Eigen::Matrix3d::Identity()});
    for (int i = 0; i < 5; ++i) scan(last.scan);
    EXPECT_EQ(error() < 0.1, may_jump) << error();
  }
}

TEST_F(TrackedRobot, ABlindLaserLeavesAHeadingThatMayBeAnything) {
  for (int i = 0; i < 3000; ++i) scan(last.scan, true);
  const auto& P = tracker.robot().covariance;
  EXPECT_LE(P(2, 2), M_PI * M_PI / 3.0 + 1e-9);
  EXPECT_GT(P(2, 2), 1.0);
  EXPECT_TRUE(P.allFinite());
}

}  // namespace
}  // namespace slam::scan_matching
