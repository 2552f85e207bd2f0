// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

std::vector<Eigen::Vector2d> circle(double radius, int points) {
  std::vector<Eigen::Vector2d> all;
  for (int i = 0; i < points; ++i)
    all.emplace_back(radius * std::cos(2.0 * M_PI * i / points),
                     radius * std::sin(2.0 * M_PI * i / points));
  return all;
}

TEST(ClosedSpline, GoesThroughItsPointsAndClosesSmoothly) {
  const ClosedSpline curve({{0, 0}, {2, 0}, {3, 1}, {1, 2}});
  const double end = curve.length();
  EXPECT_LT((curve.point(0.0) - Eigen::Vector2d(0, 0)).norm(), 1e-9);
  EXPECT_LT((curve.point(end - 1e-9) - curve.point(0.0)).norm(), 1e-6);
  EXPECT_NEAR(curve.heading(end - 1e-9), curve.heading(0.0), 1e-6);
  EXPECT_NEAR(curve.curvature(end - 1e-9), curve.curvature(0.0), 1e-5);
  double nearest = 1.0;
  for (double s = 0.0; s < end; s += 0.001)
    nearest = std::min(nearest, (curve.point(s) - Eigen::Vector2d(3, 1)).norm());
  EXPECT_LT(nearest, 1e-3);
}

TEST(ClosedSpline, IsAddressedByTheWayAlongIt) {
  const ClosedSpline curve({{0, 0}, {2, 0}, {3, 1}, {1, 2}});
  for (double s = 0.0; s < curve.length(); s += 0.0137)
    EXPECT_NEAR((curve.point(s + 1e-4) - curve.point(s)).norm(), 1e-4, 1e-9) << s;
}

TEST(ClosedSpline, ThroughPointsOfACircleIsNearlyTheCircle) {
  const ClosedSpline curve(circle(2.0, 24));
  EXPECT_NEAR(curve.length(), 4.0 * M_PI, 1e-3);
  for (double s = 0.0; s < curve.length(); s += 0.1) {
    EXPECT_NEAR(curve.point(s).norm(), 2.0, 1e-4);
    EXPECT_NEAR(curve.curvature(s), 0.5, 5e-3);
  }
}

TEST(ClosedSpline, CurvatureHasNoStep) {
  const ClosedSpline curve({{0, 0}, {2, 0}, {3, 1}, {1, 2}});
  for (double s = 0.0; s < curve.length(); s += 0.001)
    EXPECT_NEAR(curve.curvature(s + 1e-5), curve.curvature(s), 1e-3) << s;
}

class DriveOfARobot : public testing::Test {
 protected:
  DriveOfARobot() {
    path_.points = {{0, 0}, {3, 0}, {3.5, 0.5}, {3, 1}, {0, 1}, {-0.5, 0.5}};
    path_.speed = 0.8;
    path_.laps = 2;
    robot_.limits.acceleration = 0.4;
    robot_.limits.lateral_acceleration = 0.3;
    robot_.limits.turn_rate = 0.7;
  }
  DrivePath path_;
  RobotModel robot_;
};

TEST_F(DriveOfARobot, StartsAndEndsAtRestOnTheSamePlace) {
  const Drive drive(path_, robot_);
  EXPECT_EQ(drive.speed(0.0), 0.0);
  EXPECT_EQ(drive.speed(drive.duration()), 0.0);
  EXPECT_LT((drive.pose(-1.0).vector() - drive.pose(drive.duration() + 1.0).vector()).norm(), 1e-6);
  EXPECT_NEAR(drive.length(), 2.0 * ClosedSpline(path_.points).length(), 1e-9);
}

TEST_F(DriveOfARobot, KeepsEveryLimit) {
  const Drive drive(path_, robot_);
  const double dt = 0.001;
  double fastest = 0.0;
  for (double t = 0.0; t < drive.duration() - dt; t += dt) {
    const Eigen::Vector3d twist = drive.pose(t).between(drive.pose(t + dt)).log() / dt;
    fastest = std::max(fastest, twist.x());
    EXPECT_LE(twist.x(), 0.8 + 1e-3) << t;
    EXPECT_LE(std::abs(twist.z()), 0.7 + 5e-3) << t;
    EXPECT_LE(std::abs(twist.x() * twist.z()), 0.3 + 5e-3) << t;
    EXPECT_LE(std::abs(drive.speed(t + dt) - drive.speed(t)) / dt, 0.4 + 1e-3) << t;
  }
  EXPECT_NEAR(fastest, 0.8, 1e-3);  // the straight is long enough
}

/// The sharper the cusp, the narrower the turn.
TEST_F(DriveOfARobot, TurnsNoFasterWhereTheWayHasACusp) {
  const double dt = 0.001;
  for (const double gap : {2e-2, 2e-3, 2e-4, 2e-5, 2e-6}) {
    path_.points = {{0, 0}, {3, 0}, {3.5, gap}, {3, 2.0 * gap}, {0, 0.6}, {-0.5, 0.3}};
    const Drive drive(path_, robot_);
    double sharpest = 0.0, fastest_turn = 0.0, strongest = 0.0;
    for (double t = 0.0; t < drive.duration() - dt; t += dt) {
      const Eigen::Vector3d twist = drive.pose(t).between(drive.pose(t + dt)).log() / dt;
      fastest_turn = std::max(fastest_turn, std::abs(twist.z()));
      strongest = std::max(strongest, std::abs(drive.speed(t + dt) - drive.speed(t)) / dt);
      if (twist.x() > 0.0) sharpest = std::max(sharpest, std::abs(twist.z()) / twist.x());
    }
    EXPECT_GT(sharpest, 1e2) << gap;  // [1/m], so it is a cusp
    EXPECT_LE(fastest_turn, 0.75) << gap;
    EXPECT_LE(strongest, 0.4 + 1e-3) << gap;
  }
}

/// At a cusp the curvature is huge where a step happens to end.
TEST_F(DriveOfARobot, StandsAtNoCusp) {
  for (double x = 2.55; x < 3.6; x += 0.0137) {
    path_.points = {{0, 0}, {3, 0}, {x, 0.02}, {2.5, 0.034}, {0, 1.1}, {-0.5, 0.5}};
    EXPECT_LT(Drive(path_, robot_).duration(), 50.0) << x;
  }
}

TEST_F(DriveOfARobot, SpeedIsTheDerivativeOfTheWay) {
  const Drive drive(path_, robot_);
  for (double t = 0.1; t < drive.duration(); t += 0.1) {
    const double way = (drive.pose(t + 1e-4).position() - drive.pose(t - 1e-4).position()).norm();
    EXPECT_NEAR(way / 2e-4, drive.speed(t), 1e-3) << t;
  }
}

TEST_F(DriveOfARobot, ADifferentialBaseNeverDrivesSideways) {
  const Drive drive(path_, robot_);
  for (double t = 0.0; t < drive.duration(); t += 0.05)
    EXPECT_NEAR(drive.pose(t).between(drive.pose(t + 0.001)).y(), 0.0, 1e-6);
}

TEST_F(DriveOfARobot, AnOmnidirectionalBaseDoesButKeepsItsTurnRate) {
  robot_.heading_sway = 0.3;
  const Drive drive(path_, robot_);
  double sideways = 0.0;
  for (double t = 0.0; t < drive.duration(); t += 0.01) {
    const Eigen::Vector3d twist = drive.pose(t).between(drive.pose(t + 0.01)).log() / 0.01;
    sideways = std::max(sideways, std::abs(twist.y()));
    EXPECT_LE(std::abs(twist.z()), 0.7 + 0.02) << t;
  }
  EXPECT_GT(sideways, 0.1);
}

TEST_F(DriveOfARobot, IsRefusedWhereTheBaseDoesNotFit) {
  World world;
  world.walls.push_back({{-2.0, -1.0}, {4.0, -1.0}});
  const FloorPlan plan(world);
  const Drive drive(path_, robot_);
  EXPECT_NO_THROW(requireClearance(drive, plan, 0.4));
  EXPECT_THROW(requireClearance(drive, plan, 0.7), ConfigError);
}

}  // namespace
}  // namespace slam::sim
