// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_lines.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/laser_landmarks/test/simulated_trees.hpp"
#include "slam_core/laser_landmarks/test/simulated_walls.hpp"

namespace slam::laser_landmarks {
namespace {

using test::simulatedRoom;
using test::SimulatedWall;

class LaserLinesTest : public testing::Test {
 protected:
  LaserLinesTest() {
    lines_.configure(LaserLinesConfig());
    corners_.configure(LaserLinesConfig());
  }

  static std::vector<LandmarkObservation> see(WallDetector& detector, const LaserScan& scan) {
    detector.set(scan);
    EXPECT_TRUE(detector.execute().isOk());
    for (const auto& z : detector.observations()->observations) EXPECT_EQ(faultOf(z), "");
    return detector.observations()->observations;
  }
  LaserScan scanOf(const std::vector<SimulatedWall>& walls,
                   const Pose2& sensor = Pose2(0.3, 0.2, 0.1)) {
    return scanOfWalls(walls, sensor, {0.01, 0.002}, random_);
  }

  LaserLines lines_;
  LaserCorners corners_;
  RandomStream random_{1, 0};
};

TEST_F(LaserLinesTest, SeesTheWallsOfARoomOnceEach) {
  auto found = see(lines_, scanOf(simulatedRoom(), Pose2(0.3, 0.2, 0.1)));
  ASSERT_EQ(found.size(), 4u) << "also the one behind, which both ends of the sweep are on";
  for (const auto& z : found) {
    EXPECT_TRUE(z.isLine());
    EXPECT_EQ(z.id, kUnknownId);
  }
  const auto ahead = std::find_if(found.begin(), found.end(),
                                  [](const auto& z) { return std::abs(z.bearing) < 0.3; });
  ASSERT_NE(ahead, found.end());
  EXPECT_NEAR(ahead->range, 3.7, 0.03);
  EXPECT_NEAR(ahead->bearing, -0.1, 0.01);
  EXPECT_NEAR(ahead->extent.begin, -3.2, 0.1) << "from corner to corner";
  EXPECT_NEAR(ahead->extent.end, 2.8, 0.1);
}

TEST_F(LaserLinesTest, SeesTheCornersOfARoomWhereTheyAre) {
  const Pose2 sensor(0.3, 0.2, 0.1);
  const auto found = see(corners_, scanOf(simulatedRoom(), sensor));
  ASSERT_EQ(found.size(), 4u);
  for (const auto& z : found) {
    EXPECT_FALSE(z.isLine());
    const Eigen::Vector2d place =
        sensor.transform({z.range * std::cos(z.bearing), z.range * std::sin(z.bearing)});
    EXPECT_NEAR(std::abs(place.x()), 4.0, 0.04);
    EXPECT_NEAR(std::abs(place.y()), 3.0, 0.04);
  }
}

TEST_F(LaserLinesTest, AWallWithADoorInItIsOneAndHasNoCorner) {
  const std::vector<SimulatedWall> walls = {{{3, -4}, {3, -0.4}}, {{3, 0.4}, {3, 4}}};
  const auto found = see(lines_, scanOf(walls));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].extent.end - found[0].extent.begin, 7.0);
  EXPECT_TRUE(see(corners_, scanOf(walls)).empty());
}

TEST_F(LaserLinesTest, WallsBesideAGateAreTwo) {
  EXPECT_EQ(see(lines_, scanOf({{{3, -4}, {3, -1}}, {{3, 1}, {3, 4}}})).size(), 2u);
}

TEST_F(LaserLinesTest, WallsThatAreNotInLineAreTwo) {
  EXPECT_EQ(see(lines_, scanOf({{{3, -4}, {3, -0.4}}, {{3.2, 0.4}, {3.2, 4}}})).size(), 2u);
}

TEST_F(LaserLinesTest, AnEdgeOfWhichOneSideIsSeenIsNoCorner) {
  const std::vector<SimulatedWall> walls = {{{2, -3}, {2, 0}}, {{5, -6}, {5, 6}}};
  EXPECT_EQ(see(lines_, scanOf(walls)).size(), 2u);
  EXPECT_TRUE(see(corners_, scanOf(walls)).empty());
}

TEST_F(LaserLinesTest, AnEdgeOfWhichBothSidesAreSeenIsOne) {
  const std::vector<SimulatedWall> walls = {{{2.5, -2.5}, {2, 0.2}}, {{2, 0.2}, {4.5, 2.5}}};
  const auto found = see(corners_, scanOf(walls));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].range, std::hypot(1.7, 0.0), 0.03);
}

TEST_F(LaserLinesTest, AStepInAWallIsTwoLines) {
  const std::vector<SimulatedWall> walls = {
      {{3, -3}, {3, 0}}, {{3, 0}, {3.3, 0}}, {{3.3, 0}, {3.3, 3}}};
  const auto found = see(lines_, scanOf(walls));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[1].range - found[0].range, 0.3, 0.03);
}

TEST_F(LaserLinesTest, WhatIsRoundOrShortIsNoWall) {
  RandomStream random(2, 0);
  EXPECT_TRUE(see(lines_, test::scanOfTrees({{{6, -3}, 0.4}, {{8, 1}, 0.6}, {{5, 4}, 0.3}}, Pose2(),
                                            {0.01, 0.002}, random))
                  .empty());
  EXPECT_TRUE(see(lines_, scanOf({{{2, -0.2}, {2, 0.2}}})).empty());
  EXPECT_GE(lines_.counters().all().at("short"), 1u);
  EXPECT_TRUE(see(lines_, scanOf({{{25, -5}, {25, 5}}})).empty()) << "beyond max_range";
}

TEST_F(LaserLinesTest, AScanThatSeesNothingMovesTimeOn) {
  EXPECT_TRUE(see(lines_, LaserScan()).empty());
  auto scan = scanOf({});
  scan.stamp = Stamp(std::chrono::seconds(7));
  scan.sensor_pose = Pose2(0.2, 0, 0);
  EXPECT_TRUE(see(lines_, scan).empty());
  EXPECT_EQ(lines_.observations()->sequence, 1u);
  EXPECT_EQ(lines_.observations()->stamp, scan.stamp);
  EXPECT_EQ(lines_.observations()->sensor_pose.x(), 0.2);
  lines_.execute();
  EXPECT_FALSE(lines_.isBusy()) << "no scan, no array";
}

TEST_F(LaserLinesTest, ASweepOfTheOtherSenseTellsTheSame) {
  auto scan = scanOf(simulatedRoom());
  const auto one_way = see(lines_, scan);
  std::reverse(scan.beams.begin(), scan.beams.end());
  const auto other_way = see(lines_, scan);
  ASSERT_EQ(one_way.size(), other_way.size());
  for (std::size_t i = 0; i < one_way.size(); ++i)
    EXPECT_EQ(one_way[i].vector(), other_way[i].vector());
}

TEST_F(LaserLinesTest, AreAsWrongAsTheySay) {
  LaserLinesConfig config;
  config.sigma_wall = 0.0;
  lines_.configure(config);
  corners_.configure(config);
  double of_lines = 0.0, of_corners = 0.0;
  int lines = 0, corners = 0;
  for (int view = 0; view < 300; ++view) {
    const Pose2 sensor(5.0 * random_.uniform() - 2.5, 4.0 * random_.uniform() - 2.0, 0.1 * view);
    const auto scan = scanOf(simulatedRoom(), sensor);
    for (const auto& z : see(lines_, scan)) {
      const double direction = wrapAngle(z.bearing + sensor.theta());
      const double wall = M_PI / 2 * std::round(direction / (M_PI / 2));
      const Eigen::Vector2d n(std::cos(wall), std::sin(wall));
      const double half = std::abs(n.x()) > 0.5 ? 4.0 : 3.0;
      const Eigen::Vector2d error(z.range - (half - n.dot(sensor.position())), direction - wall);
      of_lines += error.dot(z.covariance.inverse() * error);
      ++lines;
    }
    for (const auto& z : see(corners_, scan)) {
      const Eigen::Vector2d seen =
          sensor.transform({z.range * std::cos(z.bearing), z.range * std::sin(z.bearing)});
      const Eigen::Vector2d corner =
          sensor.inverse().transform({std::copysign(4.0, seen.x()), std::copysign(3.0, seen.y())});
      const Eigen::Vector2d error(z.range - corner.norm(),
                                  wrapAngle(z.bearing - std::atan2(corner.y(), corner.x())));
      of_corners += error.dot(z.covariance.inverse() * error);
      ++corners;
    }
  }
  EXPECT_GT(lines, 1100);
  EXPECT_GT(corners, 1000);
  EXPECT_NEAR(of_lines / lines, 2.0, 0.4);
  EXPECT_NEAR(of_corners / corners, 2.0, 0.4);
}

TEST_F(LaserLinesTest, ForgetsEverythingOnReset) {
  see(lines_, scanOf({{{2, -0.2}, {2, 0.2}}}));
  lines_.reset();
  EXPECT_FALSE(lines_.observations());
  EXPECT_TRUE(lines_.counters().all().empty());
  see(lines_, scanOf({}));
  EXPECT_EQ(lines_.observations()->sequence, 0u);
}

TEST(LaserLines, AreDetectorsByName) {
  EXPECT_NE(Registry<LandmarkDetector>::instance().create("laser_lines"), nullptr);
  EXPECT_NE(Registry<LandmarkDetector>::instance().create("laser_corners"), nullptr);
}

}  // namespace
}  // namespace slam::laser_landmarks
