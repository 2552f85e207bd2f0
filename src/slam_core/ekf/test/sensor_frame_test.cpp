// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/sensor_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::ekf {
namespace {

CalibrationVector someParameters() {
  CalibrationVector c;
  c << 0.2, -0.1, 0.05, 0.3, -0.2, 0.2, -0.15, 0.04;
  return c;
}

const SensorFrame::View kFirst{Pose2(0.3, 0.1, 0.4), {0.5, 0.0, 0.2}};
const SensorFrame::View kSecond{Pose2(-0.2, 0.1, -2.0), {0.7, 0.1, -0.3}};

SensorFrame::Transition motionWith(const CalibrationVector& c) {
  SensorFrame::Transition U;
  U.increment = calibrated(Pose2(0.4, 0.02, 0.3), c, &U.J);
  U.Q = Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal();
  return U;
}

/// What becomes of a filter's robot at the origin, by hand: two views and a motion between them.
Pose2 movedBy(const CalibrationVector& c) {
  const Pose2 from = calibrated(kFirst.mount, kFirst.velocity, c);
  const Pose2 to = calibrated(kSecond.mount, kSecond.velocity, c);
  const Pose2 step = from.inverse() * motionWith(c).increment * to;
  const double unit = std::exp(-c(kRangeScale));
  return {unit * step.x(), unit * step.y(), step.theta()};
}

TEST(SensorFrame, MovesAsTheSensorsDo) {
  const auto c = someParameters();
  SensorFrame frame;
  frame.look(kFirst, c);
  const auto moved = frame.moved(motionWith(c), c);
  const auto looked = frame.look(kSecond, c);
  const Pose2 both = moved.increment * looked.increment;
  EXPECT_LT(movedBy(c).between(both).vector().norm(), 1e-12);
}

TEST(SensorFrame, ItsJacobiansAreDerivatives) {
  constexpr double kStep = 1e-6;
  const auto c = someParameters();
  SensorFrame frame;
  frame.look(kFirst, c);
  const auto moved = frame.moved(motionWith(c), c);
  const auto looked = frame.look(kSecond, c);
  Eigen::Matrix3d by_moved, by_looked;
  moved.increment.compose(looked.increment, &by_moved, &by_looked);
  const Eigen::MatrixXd J = by_moved * moved.J + by_looked * looked.J;
  for (Eigen::Index i = 0; i < kCalibrationRows; ++i) {
    const CalibrationVector step = kStep * CalibrationVector::Unit(i);
    const Eigen::Vector3d numeric =
        (movedBy(c + step).vector() - movedBy(c - step).vector()) / (2.0 * kStep);
    EXPECT_LT((J.col(i) - numeric).norm(), 1e-7) << i;
  }
}

TEST(SensorFrame, GivesTheRobotBack) {
  const auto c = someParameters();
  const Pose2 robot(3.0, -2.0, 1.0);
  SensorFrame frame;
  SensorFrame::Joint joint;
  joint.c = c;
  joint.covariance.setZero();
  joint.robot = inRangeUnits({robot, Eigen::Matrix3d::Zero()}, c).pose;
  EXPECT_LT(robot.between(frame.robot(joint).pose).vector().norm(), 1e-12);
  joint.robot = joint.robot * frame.look(kFirst, c).increment;
  EXPECT_LT(robot.between(frame.robot(joint).pose).vector().norm(), 1e-12);
}

/// A robot that was put somewhere in metres knows its place there, whatever the unit of the ranges.
TEST(SensorFrame, WhatIsKnownInMetresStaysKnownInMetres) {
  const auto c = someParameters();
  const Pose2 robot(3.0, -2.0, 1.0);
  Eigen::Matrix<double, 11, 11> P = Eigen::Matrix<double, 11, 11>::Zero();
  P.bottomRightCorner<8, 8>() = 0.01 * Eigen::Matrix<double, 8, 8>::Identity();
  SensorFrame frame;
  SensorFrame::Joint joint{inRangeUnits({robot, Eigen::Matrix3d::Zero()}, c).pose, c, P};
  const auto advance = [&](const SensorFrame::Transition& transition) {
    Eigen::Matrix3d F, G;
    joint.robot = joint.robot.compose(transition.increment, &F, &G);
    Eigen::Matrix<double, 11, 11> T = Eigen::Matrix<double, 11, 11>::Identity();
    T.topLeftCorner<3, 3>() = F;
    T.topRightCorner<3, 8>() = G * transition.J;
    joint.covariance = (T * joint.covariance * T.transpose()).eval();
  };
  advance(fromMetres(joint.robot));
  EXPECT_LT(frame.robot(joint).covariance.norm(), 1e-12);
  advance(frame.look(kFirst, c));
  const Eigen::Matrix3d of_sensor = joint.covariance.topLeftCorner<3, 3>();
  EXPECT_GT(of_sensor.norm(), 1e-3) << "the sensor's place is unknown";
  EXPECT_LT(frame.robot(joint).covariance.norm(), 1e-12);
}

TEST(SensorFrame, AMapInTheUnitOfTheRangesComesOutInMetres) {
  const auto c = someParameters();
  const double unit = std::exp(-c(kRangeScale));
  MapState inside;
  inside.robot.pose = Pose2(unit * 1.0, unit * 2.0, 0.5);
  inside.landmarks = {{1, {unit * 4.0, unit * 3.0}, Eigen::Matrix2d::Identity()}};
  Landmark wall{2, {unit * 2.0, 0.0}, Eigen::Matrix2d::Identity()};
  wall.kind = LandmarkKind::kLine;
  wall.extent = {unit * -1.0, unit * 1.5};
  inside.landmarks.push_back(wall);
  const Eigen::Index size = 3 + kCalibrationRows + 4;
  inside.joint_covariance = Eigen::MatrixXd::Zero(size, size);
  inside.joint_covariance(3 + kRangeScale, 3 + kRangeScale) = 0.01;
  const auto back = SensorFrame().map(inside, c);
  EXPECT_LT((back.robot.pose.vector() - Eigen::Vector3d(1.0, 2.0, 0.5)).norm(), 1e-12);
  EXPECT_LT((back.landmarks[0].position - Eigen::Vector2d(4.0, 3.0)).norm(), 1e-12);
  EXPECT_NEAR(back.landmarks[1].extent.end, 1.5, 1e-12);
  // all that the scale's doubt leaves: each coordinate is in doubt by a tenth of itself
  EXPECT_NEAR(back.landmarks[0].covariance(0, 0), 0.16, 1e-12);
  EXPECT_NEAR(back.landmarks[0].covariance(0, 1), 0.12, 1e-12);
  EXPECT_NEAR(back.landmarks[1].covariance(0, 0), 0.04, 1e-12);
  EXPECT_NEAR(back.landmarks[1].covariance(1, 1), 0.0, 1e-12) << "a direction has no scale";
  EXPECT_EQ(back.joint_covariance.rows(), 3 + 4);
}

}  // namespace
}  // namespace slam::ekf
