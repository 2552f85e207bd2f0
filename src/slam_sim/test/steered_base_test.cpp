// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/steered_base.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_sim/live_robot.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

class SteeredBaseInARoom : public testing::Test {
 protected:
  SteeredBaseInARoom() : plan_(room()) { robot_.radius = 0.25; }

  static World room() {
    World world;
    world.walls.push_back({{2.0, -5.0}, {2.0, 5.0}});
    return world;
  }

  /// One second of the same command, given ten times.
  static void drive(SteeredBase& base, const Eigen::Vector3d& velocity, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100); ++i) {
      if (i % 10 == 0) base.command(velocity);
      base.advance(0.01);
    }
  }

  FloorPlan plan_;
  RobotModel robot_;
};

TEST_F(SteeredBaseInARoom, StandsStillUntilCommanded) {
  SteeredBase base(plan_, robot_);
  base.advance(1.0);
  EXPECT_EQ(base.pose().vector(), Eigen::Vector3d::Zero());
}

TEST_F(SteeredBaseInARoom, ReachesTheCommandedVelocityAtItsAcceleration) {
  SteeredBase base(plan_, robot_);
  drive(base, {0.3, 0.0, 0.2}, 0.3);
  EXPECT_NEAR(base.velocity().x(), 0.15, 1e-9);
  drive(base, {0.3, 0.0, 0.2}, 1.0);
  EXPECT_NEAR(base.velocity().x(), 0.3, 1e-9);
  EXPECT_NEAR(base.velocity().z(), 0.2, 1e-9);
}

TEST_F(SteeredBaseInARoom, StopsHalfASecondAfterTheLastCommand) {
  SteeredBase base(plan_, robot_);
  drive(base, {0.3, 0.0, 0.0}, 1.0);
  for (int i = 0; i < 35; ++i) base.advance(0.01);
  EXPECT_NEAR(base.velocity().x(), 0.3, 1e-9);
  for (int i = 0; i < 80; ++i) base.advance(0.01);
  EXPECT_EQ(base.velocity().norm(), 0.0);
}

TEST_F(SteeredBaseInARoom, NeverDrivesThroughAWallAndGetsAwayFromIt) {
  SteeredBase base(plan_, robot_);
  drive(base, {1.0, 0.0, 0.0}, 6.0);
  EXPECT_LE(base.pose().x(), 1.75);
  EXPECT_GT(base.pose().x(), 1.7);
  EXPECT_TRUE(base.touches());
  drive(base, {-0.5, 0.0, 0.0}, 1.0);
  EXPECT_LT(base.pose().x(), 1.5);
  EXPECT_FALSE(base.touches());
}

TEST_F(SteeredBaseInARoom, OnlyAnOmnidirectionalBaseObeysSideways) {
  SteeredBase differential(plan_, robot_);
  drive(differential, {0.0, 0.3, 0.0}, 1.0);
  EXPECT_EQ(differential.pose().y(), 0.0);
  robot_.wheels.drive = "omnidirectional";
  SteeredBase omnidirectional(plan_, robot_);
  drive(omnidirectional, {0.0, 0.3, 0.0}, 1.0);
  EXPECT_GT(omnidirectional.pose().y(), 0.1);
}

TEST_F(SteeredBaseInARoom, KeepsItsLimitsAndLeavesWhatIsNoNumber) {
  SteeredBase base(plan_, robot_);
  drive(base, {-90.0, 0.0, 0.0}, 5.0);
  EXPECT_NEAR(base.velocity().x(), -robot_.limits.speed, 1e-9);
  drive(base, {0.0, 0.0, 90.0}, 5.0);
  EXPECT_NEAR(base.velocity().z(), robot_.limits.turn_rate, 1e-9);
  base.command({std::nan(""), 0.0, 0.0});
  base.advance(0.01);
  EXPECT_TRUE(base.pose().isFinite());
}

class LiveRobotInTheOffice : public testing::Test {
 protected:
  const World world_ = readWorldFile(std::string(SLAM_SIM_FOLDER) + "/worlds/office.yaml");
  const RobotModel robot_ = readRobotFile(std::string(SLAM_SIM_FOLDER) + "/robots/segway.yaml");
};

TEST_F(LiveRobotInTheOffice, FollowsThePathUntilACommandComes) {
  LiveRobot robot(world_, robot_, 1, true);
  double time = 0.0;
  for (; time < 3.0; time += 0.02) robot.advance(time);
  const Drive drive(world_.path, robot_);
  EXPECT_LT((robot.pose(time).vector() - drive.pose(time).vector()).norm(), 1e-9);
  EXPECT_NEAR(robot.measuredVelocity().x(), 0.3, 0.1);
  robot.command(Eigen::Vector3d::Zero());
  const auto stopped = robot.pose(time).vector();
  for (; time < 5.0; time += 0.02) robot.advance(time);
  EXPECT_LT((robot.pose(time).vector() - stopped).norm(), 0.02);
}

TEST_F(LiveRobotInTheOffice, LeavesOutATimeThatIsNotLater) {
  LiveRobot robot(world_, robot_, 1, true);
  EXPECT_TRUE(robot.advance(1.0));
  EXPECT_FALSE(robot.advance(1.0));
  EXPECT_FALSE(robot.advance(0.5));
  EXPECT_TRUE(robot.advance(1.02));
}

}  // namespace
}  // namespace slam::sim
