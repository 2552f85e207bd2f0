// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/wheel_encoders.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "slam_core/models/motion_model.hpp"
#include "slam_sim/drive.hpp"
#include "slam_sim/sensors.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

constexpr OdometryNoise kNoise = {0.002, 0.001, 0.003, 0.004, false};

/// Mean and covariance of what is measured of one way, cut into `steps` pieces.
struct Statistics {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

Statistics measureOften(const WheelEncoders& encoders, const Eigen::Vector3d& twist, int steps) {
  constexpr int kRuns = 20000;
  std::vector<Eigen::Vector3d> all;
  Statistics result;
  for (int run = 0; run < kRuns; ++run) {
    RandomStream random(7, static_cast<std::uint64_t>(run));
    Pose2 pose;
    for (int i = 0; i < steps; ++i)
      pose = pose * Pose2::exp(encoders.measure(twist / steps, random));
    all.push_back(pose.vector());
    result.mean += all.back() / kRuns;
  }
  for (const auto& value : all)
    result.covariance += (value - result.mean) * (value - result.mean).transpose() / kRuns;
  return result;
}

void expectNear(const Eigen::Matrix3d& measured, const Eigen::Matrix3d& expected, double share) {
  const double scale_xx = expected(0, 0) + expected(1, 1), scale_tt = expected(2, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double scale = std::sqrt((i < 2 ? scale_xx : scale_tt) * (j < 2 ? scale_xx : scale_tt));
      EXPECT_NEAR(measured(i, j), expected(i, j), share * scale) << i << ", " << j;
    }
}

TEST(WheelEncoders, NoiseIsThatOfTheLinearMotionModel) {
  const WheelEncoders encoders({"differential", 0.5, 1.0, {1.0, 1.0}}, kNoise);
  const Eigen::Vector3d twist(0.6, 0.0, 0.4);
  const auto statistics = measureOften(encoders, twist, 50);
  expectNear(statistics.covariance, LinearMotionModel(kNoise).covariance(Pose2::exp(twist)), 0.05);
  EXPECT_LT((statistics.mean - Pose2::exp(twist).vector()).norm(), 0.003);
}

TEST(WheelEncoders, NoiseOfAWayDoesNotDependOnTheRate) {
  const WheelEncoders encoders({"differential", 0.5, 1.0, {1.0, 1.0}}, kNoise);
  const Eigen::Vector3d twist(0.5, 0.0, -0.3);
  const auto slow = measureOften(encoders, twist, 10), fast = measureOften(encoders, twist, 40);
  expectNear(fast.covariance, slow.covariance, 0.06);
}

TEST(WheelEncoders, AnOmnidirectionalBaseSlipsAcrossItsWayToo) {
  auto noise = kNoise;
  noise.omnidirectional = true;
  const WheelEncoders encoders({"omnidirectional", 0.3, 1.0, {1, 1, 1, 1}}, noise);
  const Eigen::Vector3d twist(0.3, 0.4, 0.0);
  const auto statistics = measureOften(encoders, twist, 20);
  expectNear(statistics.covariance, LinearMotionModel(noise).covariance(Pose2::exp(twist)), 0.05);
}

TEST(WheelEncoders, ABaseAtRestMeasuresNothing) {
  const WheelEncoders encoders({"differential", 0.5, 0.98, {0.99, 1.01}}, kNoise);
  RandomStream random(1, 1);
  EXPECT_EQ(encoders.measure(Eigen::Vector3d::Zero(), random), Eigen::Vector3d::Zero());
}

TEST(WheelEncoders, UnequalWheelsTurnAStraightWayAndAShortLeverEnlargesTurns) {
  const WheelEncoders encoders({"differential", 0.5, 0.98, {0.99, 1.01}}, {});
  const Eigen::Vector3d straight = encoders.systematic() * Eigen::Vector3d(1, 0, 0);
  EXPECT_NEAR(straight.x(), 1.0, 1e-12);
  EXPECT_NEAR(straight.z(), 0.02 / (0.5 * 0.98), 1e-12);
  const Eigen::Vector3d turn = encoders.systematic() * Eigen::Vector3d(0, 0, 1);
  EXPECT_NEAR(turn.z(), 1.0 / 0.98, 1e-12);
}

TEST(WheelEncoders, AFaultlessOmnidirectionalBaseMeasuresItsMotion) {
  const WheelEncoders encoders({"omnidirectional", 0.3, 1.0, {1, 1, 1, 1}}, {});
  EXPECT_TRUE(encoders.systematic().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
}

/// Root mean square of the distances after a rigid alignment in the plane.
double alignedError(const Eigen::Matrix2Xd& estimate, const Eigen::Matrix2Xd& truth) {
  const Eigen::Matrix2Xd a = estimate.colwise() - estimate.rowwise().mean();
  const Eigen::Matrix2Xd b = truth.colwise() - truth.rowwise().mean();
  const double cross =
      (a.row(0).array() * b.row(1).array() - a.row(1).array() * b.row(0).array()).sum();
  const Eigen::Matrix2d R =
      Eigen::Rotation2Dd(std::atan2(cross, (a.array() * b.array()).sum())).toRotationMatrix();
  return std::sqrt((R * a - b).colwise().squaredNorm().mean());
}

TEST(WheelOdometer, DriftsAtLeastAQuarterOfAMetreInTheOfficeOnEverySeed) {
  const std::string folder = SLAM_SIM_FOLDER;
  const auto world = readWorldFile(folder + "/worlds/office.yaml");
  for (const std::string name : {"segway", "omni"}) {
    const auto robot = readRobotFile(folder + "/robots/" + name + ".yaml");
    const Drive drive(world.path, robot);
    const auto steps = static_cast<Eigen::Index>(drive.duration() * robot.odometry.rate);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Sensors sensors(world, robot, seed);
      WheelOdometer odometer(WheelEncoders(robot.wheels, robot.noise));
      Eigen::Matrix2Xd estimate(2, steps), truth(2, steps);
      for (Eigen::Index i = 0; i < steps; ++i) {
        const auto pose = drive.pose(static_cast<double>(i) / robot.odometry.rate);
        auto noise = sensors.wheelNoise(static_cast<std::uint64_t>(i));
        odometer.moveTo(pose, noise);
        estimate.col(i) = odometer.pose().position();
        truth.col(i) = pose.position();
      }
      EXPECT_GE(alignedError(estimate, truth), 0.25) << name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace slam::sim
