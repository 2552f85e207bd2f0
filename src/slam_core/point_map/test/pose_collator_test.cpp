// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/pose_collator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::point_map {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

/// Ahead at 1 m/s with a turn.
Motion motion(double start, double end, std::uint64_t sequence) {
  Motion m;
  m.sequence = sequence;
  m.start = at(start);
  m.end = at(end);
  m.increment = Pose2::exp({end - start, 0, 0.1 * (end - start)});
  m.covariance = Eigen::Matrix3d::Identity() * 1e-4;
  return m;
}

FilterPose poseAt(double s, double x) { return FilterPose::of(at(s), {x, 0.0, 0.0}); }

LaserScan scanAt(double s, std::uint64_t sequence = 0) {
  LaserScan scan;
  scan.stamp = at(s);
  scan.sequence = sequence;
  return scan;
}

TEST(FilterPose, HasTheBitsOfOneThatWentThroughAMessage) {
  RandomStream random(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 pose(random.gaussian(), random.gaussian(), 20 * random.gaussian());
    const auto sent = FilterPose::of(at(i), pose);
    const FilterPose received{sent.stamp, sent.x, sent.y, sent.qz, sent.qw};
    EXPECT_EQ(received.pose().theta(), sent.pose().theta());
    EXPECT_NEAR(std::remainder(sent.pose().theta() - pose.theta(), 2 * M_PI), 0.0, 1e-12);
  }
}

TEST(PoseCollator, CarriesTheLastPoseOnByMotion) {
  PoseCollator collator;
  collator.push(motion(0, 1, 0));
  collator.push(motion(1, 2, 1));
  collator.push(poseAt(0.5, 10));
  collator.push(poseAt(1.8, 50));
  collator.push(scanAt(1.5));
  const auto placed = collator.next();
  ASSERT_TRUE(placed);
  const auto expected = Pose2(10, 0, 0) * Pose2::exp({1, 0, 0.1});
  EXPECT_LT((placed->T_map_base.vector() - expected.vector()).norm(), 1e-9);
}

TEST(PoseCollator, WaitsForAPoseAtOrAfterTheScanAndForMotion) {
  PoseCollator collator;
  collator.push(motion(0, 1, 0));
  collator.push(poseAt(0.2, 1));
  collator.push(scanAt(0.7));
  EXPECT_FALSE(collator.next()) << "a later pose may yet be nearer";
  collator.push(poseAt(0.7, 2));
  const auto placed = collator.next();
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->T_map_base.x(), 2.0) << "a pose of the scan's own stamp needs no motion";
  collator.push(scanAt(1.2, 1));
  collator.push(poseAt(1.3, 3));
  EXPECT_FALSE(collator.next()) << "motion does not cover it";
  collator.push(motion(1, 2, 1));
  EXPECT_TRUE(collator.next());
}

TEST(PoseCollator, OfSeveralPosesOfOneStampTheFirstCounts) {
  PoseCollator collator;
  collator.push(motion(0, 1, 0));
  collator.push(poseAt(0.5, 1));
  collator.push(poseAt(0.5, 2));
  collator.push(scanAt(0.5));
  EXPECT_EQ(collator.next()->T_map_base.x(), 1.0);
  EXPECT_TRUE(collator.counters().all().empty());
}

TEST(PoseCollator, AScanBeforeTheFirstPoseIsLeftOutAndCounted) {
  PoseCollator collator;
  collator.push(motion(0, 1, 0));
  collator.push(scanAt(0.1));
  collator.push(poseAt(0.5, 1));
  EXPECT_FALSE(collator.next());
  EXPECT_EQ(collator.counters()["before_pose"], 1u);
}

TEST(PoseCollator, APoseBeforeTheFirstMotionLeadsToNoLaterScan) {
  PoseCollator collator;
  collator.push(poseAt(0.5, 1));
  collator.push(motion(0.8, 1.8, 7));  // what was before has come to nobody
  collator.push(scanAt(0.5, 0));
  collator.push(scanAt(1.0, 1));
  collator.push(scanAt(1.6, 2));
  collator.push(poseAt(1.5, 2));
  collator.push(poseAt(1.6, 3));
  EXPECT_EQ(collator.next()->T_map_base.x(), 1.0) << "one of the pose's own stamp needs no motion";
  EXPECT_EQ(collator.next()->T_map_base.x(), 3.0);
  EXPECT_EQ(collator.counters()["before_motion"], 1u);
}

TEST(PoseCollator, GivesTheSameWhateverTheOrderOfArrival) {
  std::vector<Pose2> expected;
  for (std::uint64_t shuffle = 0; shuffle < 50; ++shuffle) {
    PoseCollator collator;
    RandomStream random(2, shuffle);
    std::vector<Pose2> poses;
    std::uint64_t next[3] = {0, 0, 0};
    const std::uint64_t ends[3] = {200, 95, 60};
    while (next[0] < ends[0] || next[1] < ends[1] || next[2] < ends[2]) {
      const auto source = static_cast<std::size_t>(3 * random.uniform()) % 3;
      if (next[source] == ends[source]) continue;
      const auto i = next[source]++;
      const auto s = static_cast<double>(i);
      if (source == 0) collator.push(motion(0.05 * s, 0.05 * (s + 1), i));
      if (source == 1) collator.push(poseAt(0.01 + 0.1 * s, s));
      if (source == 2) collator.push(scanAt(0.04 + 0.15 * s, i));
      while (auto placed = collator.next()) poses.push_back(placed->T_map_base);
    }
    if (shuffle == 0) expected = poses;
    ASSERT_GT(poses.size(), 50u);
    ASSERT_EQ(poses.size(), expected.size()) << "shuffle " << shuffle;
    for (std::size_t i = 0; i < poses.size(); ++i)
      ASSERT_EQ(poses[i].vector(), expected[i].vector()) << "shuffle " << shuffle;
  }
}

/// Of two minutes, one source of motion (0), poses (1) and scans (2) after the others have told
/// all.
std::vector<Pose2> placedWithLast(std::size_t late) {
  PoseCollator collator;
  std::vector<Pose2> poses;
  for (const auto source : {(late + 1) % 3, (late + 2) % 3, late})
    for (std::uint64_t i = 0; i < 1200; ++i) {
      const auto s = static_cast<double>(i);
      if (source == 0) collator.push(motion(0.1 * s, 0.1 * (s + 1), i));
      if (source == 1) collator.push(poseAt(0.01 + 0.1 * s, s));
      if (source == 2) collator.push(scanAt(0.04 + 0.1 * s, i));
      while (auto placed = collator.next()) poses.push_back(placed->T_map_base);
    }
  EXPECT_TRUE(collator.counters().all().empty()) << late;
  return poses;
}

TEST(PoseCollator, WhatComesMinutesLateIsNotLate) {
  const auto expected = placedWithLast(0);
  EXPECT_EQ(expected.size(), 1199u);
  for (const std::size_t late : {1, 2}) {
    const auto poses = placedWithLast(late);
    ASSERT_EQ(poses.size(), expected.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
      ASSERT_EQ(poses[i].vector(), expected[i].vector()) << late;
  }
}

TEST(PoseCollator, BeginsAnewWhenAllSourcesGoBack) {
  PoseCollator collator;
  collator.push(motion(100, 101, 0));
  collator.push(poseAt(100.2, 1));
  collator.push(scanAt(100.1));
  collator.next();
  collator.push(scanAt(10.6, 1));
  collator.push(poseAt(10.5, 7));
  collator.push(motion(10, 11, 1));
  collator.push(poseAt(10.7, 8));
  const auto placed = collator.next();
  ASSERT_TRUE(placed);
  EXPECT_TRUE(placed->restart);
  EXPECT_NEAR(placed->T_map_base.x(), 7.1, 1e-3);
  EXPECT_EQ(collator.counters()["restart"], 1u);
}

TEST(PoseCollator, KeepsLittleWhileNoScanComes) {
  PoseCollator collator;
  for (std::uint64_t i = 0; i < 50000; ++i) {
    const auto s = static_cast<double>(i);
    collator.push(motion(0.01 * s, 0.01 * (s + 1), i));
    collator.push(poseAt(0.01 * s, s));
    collator.next();
  }
  EXPECT_TRUE(collator.counters().all().empty()) << "nothing has overflown";
  collator.push(scanAt(499.5));
  EXPECT_TRUE(collator.next());
}

}  // namespace
}  // namespace slam::point_map
