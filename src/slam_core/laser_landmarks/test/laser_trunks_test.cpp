// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_trunks.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
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
  const auto counted = detector_.counters().all();
  EXPECT_TRUE(see(scanOf({{{75, 0}, 0.7}})).empty());
  EXPECT_EQ(detector_.counters().all(), counted) << "what is beyond max_range is not counted";
}

TEST_F(LaserTrunksTest, OneBeamIsATrunkUnlessMoreAreAskedFor) {
  const auto scan = scanOf({{{25, 0}, 0.15}});
  const auto& found = see(scan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].range, 25.0, 0.3);
  LaserTrunksConfig config;
  config.min_points = 3;
  detector_.configure(config);
  EXPECT_TRUE(see(scan).empty());
  EXPECT_EQ(detector_.counters().all().at("few_points"), 1u);
}

TEST_F(LaserTrunksTest, FarRangesThatErrMoreHaveALargerCovariance) {
  auto scan = scanOf({{{8, 0}, 0.3}});
  const auto before = see(scan).at(0).covariance(0, 0);
  scan.relative_sigma = 0.05;
  EXPECT_GT(see(scan).at(0).covariance(0, 0), 2.0 * before);
}

TEST_F(LaserTrunksTest, NoiseThatGrowsWithTheRangeCutsNoTrunk) {
  constexpr double kRelative = 0.004;
  int views = 0;
  for (int view = 0; view < 300; ++view) {
    auto scan =
        scanOfTrees({{{55, 0.01 * view}, 0.7}}, Pose2(), TreeLaser{55 * kRelative, 0.0}, random_);
    scan.relative_sigma = kRelative;
    const auto& found = see(scan);
    EXPECT_LE(found.size(), 1u) << "its parts are no trunks";
    views += found.empty() ? 0 : 1;
  }
  EXPECT_GT(views, 250);
}

TEST_F(LaserTrunksTest, InAForestItSeesTreesOnlyAndIsAsWrongAsItSays) {
  std::vector<Tree> trees;  // a tree somewhere in each square of 6 m
  for (int row = -5; row <= 5; ++row)
    for (int column = -5; column <= 5; ++column)
      trees.push_back(
          {{6.0 * row + 3.0 * random_.uniform(), 6.0 * column + 3.0 * random_.uniform()},
           0.12 + 0.35 * random_.uniform()});
  const TreeLaser laser{0.05, 0.003};
  double sum = 0.0;
  int seen = 0;
  for (int view = 0; view < 300; ++view) {
    const Pose2 base(6.0 * (view % 7) - 19.0, 6.0 * (view % 5) - 13.0, 0.3 * view);
    for (const auto& observation : see(scanOfTrees(trees, base, laser, random_))) {
      double nearest = 1e9, nees = 0.0;
      for (const auto& tree : trees) {
        const Eigen::Vector2d p = base.inverse().transform(tree.position);
        const Eigen::Vector2d error(observation.range - p.norm(),
                                    wrapAngle(observation.bearing - std::atan2(p.y(), p.x())));
        const double distance = std::hypot(error.x(), observation.range * error.y());
        if (distance > nearest) continue;
        nearest = distance;
        nees = error.dot(observation.covariance.inverse() * error);
      }
      EXPECT_LT(nearest, 1.0) << "a ghost";
      sum += nees;
      ++seen;
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(sum / seen, 2.6);
  EXPECT_GT(sum / seen, 1.5);
}

/// The radius's error over its sigma, of single scans and, for a tree that is passed, in the mean.
TEST_F(LaserTrunksTest, TheRadiusErrsAsMuchAsItSays) {
  for (const double nearest : {3.0, 10.0, 25.0}) {
    double single = 0.0, beyond = 0.0, of_mean = 0.0;
    int seen = 0, drives = 0;
    for (int drive = 0; drive < 300; ++drive) {
      const Tree tree{{nearest + 10.0 + nearest * random_.uniform(), 6 * random_.uniform() - 3},
                      0.1 + 0.35 * random_.uniform()};
      double error = 0.0, variance = 0.0;
      for (int scan = 0; scan < 15; ++scan) {
        const Pose2 base(0.6 * scan, 0, 0);
        for (const auto& z : see(scanOfTrees({tree}, base, TreeLaser{0.05, 0.003}, random_))) {
          const double e = z.descriptor.values(0) - tree.radius, sigma = z.descriptor.sigmas(0);
          single += e * e / (sigma * sigma);
          beyond += std::abs(e) > 3.0 * sigma;
          error += e;
          variance += sigma * sigma;
          ++seen;
        }
      }
      if (variance == 0.0) continue;
      of_mean += error * error / variance;
      ++drives;
    }
    RecordProperty("nees_" + std::to_string(int(nearest)), std::to_string(single / seen));
    RecordProperty("beyond_" + std::to_string(int(nearest)), std::to_string(beyond / seen));
    RecordProperty("mean_" + std::to_string(int(nearest)), std::to_string(of_mean / drives));
    ASSERT_GT(seen, 1000);
    EXPECT_GT(single / seen, 0.3) << "from " << nearest << " m on";
    EXPECT_LT(single / seen, 1.5) << "from " << nearest << " m on";
    EXPECT_LT(beyond / seen, 0.01) << "from " << nearest << " m on";
    EXPECT_LT(of_mean / drives, 1.5) << "from " << nearest << " m on";
  }
}

/// A car passes a far tree and sees it in each of ten scans: the mean of their errors is as large
/// as if the errors that the covariance holds were independent.
TEST_F(LaserTrunksTest, FarTrunksErrNoMoreThanItSaysInTheMeanOfManyScans) {
  constexpr int kScans = 30;
  double sum = 0.0;
  int drives = 0;
  for (int drive = 0; drive < 500; ++drive) {
    const Tree tree{{40 + 25 * random_.uniform(), 6 * random_.uniform() - 3},
                    0.1 + 0.35 * random_.uniform()};
    Eigen::Vector2d error = Eigen::Vector2d::Zero();
    Eigen::Matrix2d P = Eigen::Matrix2d::Zero();
    int seen = 0;
    for (int scan = 0; scan < kScans; ++scan) {
      const Pose2 base(0.6 * scan, 0, 0);
      for (const auto& z : see(scanOfTrees({tree}, base, TreeLaser{0.05, 0.003}, random_))) {
        const Eigen::Vector2d p = base.inverse().transform(tree.position);
        error +=
            Eigen::Vector2d(z.range - p.norm(), wrapAngle(z.bearing - std::atan2(p.y(), p.x())));
        P += z.covariance;
        ++seen;
      }
    }
    if (seen < kScans / 2) continue;
    sum += error.dot(P.inverse() * error);
    ++drives;
  }
  EXPECT_GT(drives, 300);
  EXPECT_LT(sum / drives, 2.6);
  EXPECT_GT(sum / drives, 1.2);
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
