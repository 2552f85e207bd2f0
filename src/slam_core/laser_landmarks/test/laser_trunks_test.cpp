// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_trunks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/contract/registry.hpp"
#include "slam_core/laser_landmarks/test/simulated_trees.hpp"

namespace slam::laser_landmarks {
namespace {

using test::Tree;
using test::TreeLaser;

class LaserTrunksTest : public testing::Test {
 protected:
  LaserTrunksTest() { detector_.configure(LaserTrunksConfig()); }

  const std::vector<LandmarkObservation>& see(const LaserScan& scan) {
    detector_.set(scan);
    EXPECT_TRUE(detector_.execute().isOk());
    return detector_.observations()->observations;
  }
  LaserScan scanOf(const std::vector<Tree>& trees) {
    return scanOfTrees(trees, Pose2(), TreeLaser(), random_);
  }

  LaserTrunks detector_;
  RandomStream random_{1, 0};
};

TEST_F(LaserTrunksTest, SeesTreesWithoutNamesByRisingBearing) {
  const auto& found = see(scanOf({{{6, -3}, 0.2}, {{8, 0}, 0.3}, {{5, 4}, 0.15}}));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0].bearing, std::atan2(-3, 6), 0.005);
  EXPECT_NEAR(found[0].range, std::hypot(3, 6), 0.05);
  EXPECT_NEAR(found[1].range, 8.0, 0.05);
  EXPECT_NEAR(found[2].bearing, std::atan2(4, 5), 0.005);
  for (const auto& observation : found) {
    EXPECT_EQ(observation.id, kUnknownId);
    EXPECT_TRUE(faultOf(observation).empty());
  }
  EXPECT_TRUE(detector_.counters().all().empty());
}

TEST_F(LaserTrunksTest, TellsWhereTheLaserIsAndCountsItsArrays) {
  auto scan = scanOf({{{6, 0}, 0.3}});
  scan.sensor_pose = Pose2(3.78, 0.5, 0.0);
  scan.stamp = Stamp(std::chrono::seconds(7));
  see(scan);
  see(scan);
  const auto& array = *detector_.observations();
  EXPECT_EQ(array.sequence, 1u);
  EXPECT_EQ(array.stamp, scan.stamp);
  EXPECT_EQ(array.sensor_frame, "laser");
  EXPECT_EQ(array.sensor_pose.x(), 3.78);
}

TEST_F(LaserTrunksTest, AScanThatSeesNothingMovesTimeOn) {
  EXPECT_TRUE(see(LaserScan()).empty());
  EXPECT_TRUE(see(scanOf({})).empty());
  detector_.execute();
  EXPECT_FALSE(detector_.isBusy()) << "no scan, no array";
}

TEST_F(LaserTrunksTest, ASweepOfTheOtherSenseTellsTheSame) {
  auto scan = scanOf({{{6, -3}, 0.2}, {{8, 0}, 0.3}});
  const auto one_way = see(scan);
  std::reverse(scan.beams.begin(), scan.beams.end());
  const auto other_way = see(scan);
  ASSERT_EQ(one_way.size(), other_way.size());
  for (std::size_t i = 0; i < one_way.size(); ++i)
    EXPECT_EQ(one_way[i].vector(), other_way[i].vector());
}

TEST_F(LaserTrunksTest, WhatMayBeHiddenIsNoLandmark) {
  const auto& found = see(scanOf({{{8, 0}, 0.5}, {{4, 0.2}, 0.1}}));
  ASSERT_EQ(found.size(), 1u) << "the tree behind is seen in part only";
  EXPECT_NEAR(found[0].range, 4.0, 0.05);
  EXPECT_GE(detector_.counters().all().at("hidden"), 1u);
}

TEST_F(LaserTrunksTest, WhatMayBeCutOffIsNoLandmark) {
  EXPECT_TRUE(see(scanOf({{{0.2, -6}, 0.4}})).empty()) << "at the end of the sweep";
  EXPECT_EQ(detector_.counters().all().at("cut_off"), 1u);
  auto scan = scanOf({{{8, 0}, 0.5}});
  scan.beams.erase(scan.beams.begin() + 180);
  EXPECT_TRUE(see(scan).empty()) << "a beam in its middle told nothing";
  EXPECT_EQ(detector_.counters().all().at("cut_off"), 3u);
}

TEST_F(LaserTrunksTest, WhatIsTooThinTooThickOrTooFarIsNoLandmark) {
  EXPECT_TRUE(see(scanOf({{{1.2, 0}, 0.015}})).empty());
  EXPECT_EQ(detector_.counters().all().at("too_thin"), 1u);
  EXPECT_TRUE(see(scanOf({{{10, 0}, 2.0}})).empty());
  EXPECT_EQ(detector_.counters().all().at("too_thick"), 1u);
  EXPECT_TRUE(see(scanOf({{{30, 0}, 0.1}})).empty());
  EXPECT_GE(detector_.counters().all().at("few_points"), 1u);
  EXPECT_TRUE(see(scanOf({{{45, 0}, 0.7}})).empty());
  EXPECT_EQ(detector_.counters().all().size(), 3u) << "what is beyond max_range is not counted";
}

TEST_F(LaserTrunksTest, FarRangesThatErrMoreHaveALargerCovariance) {
  auto scan = scanOf({{{8, 0}, 0.3}});
  const auto before = see(scan).at(0).covariance(0, 0);
  scan.relative_sigma = 0.05;
  EXPECT_GT(see(scan).at(0).covariance(0, 0), 2.0 * before);
}

TEST_F(LaserTrunksTest, ForgetsEverythingOnReset) {
  see(scanOf({{{0.2, -6}, 0.4}}));
  detector_.reset();
  EXPECT_FALSE(detector_.observations());
  EXPECT_TRUE(detector_.counters().all().empty());
  see(scanOf({}));
  EXPECT_EQ(detector_.observations()->sequence, 0u);
}

TEST_F(LaserTrunksTest, RefusesLimitsThatNothingMeets) {
  LaserTrunksConfig config;
  config.min_diameter = 2.0;
  try {
    detector_.configure(config);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("less than laser_trunks.max_diameter"),
              std::string::npos);
  }
}

TEST(LaserTrunks, IsADetectorByName) {
  EXPECT_NE(Registry<LandmarkDetector>::instance().create("laser_trunks"), nullptr);
}

}  // namespace
}  // namespace slam::laser_landmarks
