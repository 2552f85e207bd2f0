// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <string>

#include "slam_core/imu_odometry/test/driven_odometry.hpp"

// How well the heading is known, over many robots and drives.

namespace slam::imu_odometry {
namespace {

using test::DrivenOdometry;
using test::GyroErrors;
using test::Leg;
using test::TurningRobot;
using test::WheelErrors;

std::vector<Leg> repeated(const std::vector<Leg>& legs, int times) {
  std::vector<Leg> all = {{1.0, 0.0, 0.0}};
  for (int i = 0; i < times; ++i) all.insert(all.end(), legs.begin(), legs.end());
  return all;
}

/// Root mean square of the heading's error over pieces of the drive [rad].
template <class TurnOf>
double drift(const TurningRobot& robot, std::size_t motions, std::size_t piece, TurnOf turnOf) {
  double squares = 0.0;
  std::size_t pieces = 0;
  for (std::size_t i = 0; i + piece <= motions; i += piece, ++pieces) {
    const double truth = robot.truth()[i].pose.between(robot.truth()[i + piece].pose).theta();
    squares += std::pow(std::remainder(turnOf(i, i + piece) - truth, 2.0 * M_PI), 2);
  }
  return std::sqrt(squares / static_cast<double>(pieces));
}

struct Drift {
  double gyro, wheels;  ///< in a quarter of a minute [rad]
};

Drift driftOf(const TurningRobot& robot, const DrivenOdometry& driven, double wheel_rate) {
  const auto piece = static_cast<std::size_t>(15.0 * wheel_rate);
  const auto count = driven.motions.size();
  const auto of_gyro = [&](std::size_t begin, std::size_t end) {
    double turn = 0.0;
    for (std::size_t i = begin; i < end; ++i) turn += driven.motions[i].increment.theta();
    return turn;
  };
  const auto of_wheels = [&](std::size_t begin, std::size_t end) {
    return robot.wheels()[begin].pose->between(*robot.wheels()[end].pose).theta();
  };
  return {drift(robot, count, piece, of_gyro), drift(robot, count, piece, of_wheels)};
}

struct RobotType {
  const char* name;
  WheelErrors wheels;
  GyroErrors gyro;
  TurningRobot::Rates rates;
};

const RobotType kRobotTypes[] = {
    {"two wheels, MEMS",
     {0.02, 0.04, {5e-5, 1e-5, 5e-5, 1e-4}},
     {0.008, 2e-5, 2e-4, 0.005},
     {50, 100}},
    {"skid-steer, MEMS",
     {0.4, 0.02, {1e-3, 5e-4, 4e-3, 1e-2}},
     {-0.005, 3e-5, 4e-4, -0.01},
     {20, 50}},
    {"skid-steer, turns too small",
     {-0.3, -0.05, {1e-3, 5e-4, 8e-3, 2e-2}},
     {0.015, 2e-5, 2e-4, 0.0},
     {10, 100}},
    {"tracks, fibre optics",
     {1.0, 0.1, {1e-3, 5e-4, 4e-3, 1e-2}},
     {1e-4, 1e-7, 2e-5, 5e-4},
     {50, 100}},
};

const struct {
  const char* name;
  std::vector<Leg> legs;
} kDrives[] = {
    {"all sorts", repeated(test::someDrive(1.0), 8)},
    {"never stands", repeated({{10, 0.6, 0.0}, {4, 0.4, 0.4}, {10, 0.6, 0.02}, {5, 0.4, -0.3}}, 9)},
    {"circles", repeated({{280, 0.5, 0.3}}, 1)},
    {"aisles",
     repeated({{20, 1.0, 0.0}, {2, 0.2, 0.78}, {3, 1.0, 0.0}, {2, 0.2, 0.78}, {1, 0.0, 0.0}}, 9)},
};

TEST(HeadingDrift, IsAtMostAFifthOfTheWheels) {
  std::printf("drift of the heading in 15 s, in degrees, root mean square of 5 seeds\n");
  for (const auto& type : kRobotTypes)
    for (const auto& drive : kDrives) {
      double gyro = 0.0, wheels = 0.0;
      constexpr int kSeeds = 5;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        TurningRobot robot(seed, type.wheels, type.gyro, type.rates);
        robot.drive(drive.legs);
        DrivenOdometry driven;
        driven.take(robot);
        EXPECT_EQ(driven.messages, std::vector<std::string>()) << type.name << ", " << drive.name;
        const auto drifted = driftOf(robot, driven, type.rates.wheels);
        gyro += drifted.gyro * drifted.gyro / kSeeds;
        wheels += drifted.wheels * drifted.wheels / kSeeds;
      }
      constexpr double kDegrees = 180.0 / M_PI;
      std::printf("%-28s %-13s gyro %6.3f, wheels %7.3f\n", type.name, drive.name,
                  kDegrees * std::sqrt(gyro), kDegrees * std::sqrt(wheels));
      EXPECT_LE(std::sqrt(gyro), 0.2 * std::sqrt(wheels)) << type.name << ", " << drive.name;
    }
}

/// Errors as the robot file says that they are.
TurningRobot honestRobot(std::uint64_t seed) {
  RandomStream random(seed, 1);
  const ImuConfig config;
  const GyroErrors gyro{config.bias_sigma * random.gaussian(), config.bias_random_walk, 3e-4,
                        config.scale_sigma * random.gaussian()};
  const OdometryNoise noise{0.002, 0.0005, 0.002, 0.005, true};
  return TurningRobot(seed, {0.2 * random.gaussian(), 0.02 * random.gaussian(), noise}, gyro);
}

struct Nees {
  double of_pose = 0.0, of_heading = 0.0;
};

/// Mean over pieces of so many motions.
Nees neesOf(const TurningRobot& robot, const std::vector<Motion>& motions, std::size_t piece) {
  Nees nees;
  double pieces = 0.0;
  for (std::size_t i = 0; i + piece <= motions.size(); i += piece, ++pieces) {
    Motion motion = motions[i];
    for (std::size_t k = i + 1; k < i + piece; ++k) motion = joined(motion, motions[k]);
    const auto truth = robot.truth()[i].pose.between(robot.truth()[i + piece].pose);
    Eigen::Vector3d error = motion.increment.vector() - truth.vector();
    error.z() = std::remainder(error.z(), 2.0 * M_PI);
    nees.of_pose += error.dot(motion.covariance.inverse() * error);
    nees.of_heading += error.z() * error.z() / motion.covariance(2, 2);
  }
  return {nees.of_pose / pieces, nees.of_heading / pieces};
}

/// Errors that last, of bias and scale, cannot be independent ones for each length of way:
/// the covariances are made to fit seconds to half a minute, and are too large for less.
TEST(HeadingDrift, CovarianceIsAsLargeAsTheErrors) {
  const struct {
    std::size_t motions;
    double least, most, least_of_heading;
  } lengths[] = {
      {1, 1.5, 3.3, 0.01}, {40, 1.5, 3.5, 0.1}, {400, 1.7, 4.0, 0.3}, {1200, 1.2, 4.0, 0.05}};
  constexpr int kSeeds = 60;
  std::vector<TurningRobot> robots;
  std::vector<std::vector<Motion>> motions;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    robots.push_back(honestRobot(seed));
    robots.back().drive(repeated(test::someDrive(1.0), 3));
    DrivenOdometry driven("{version: 1, wheel_odometry: {drive: omnidirectional}}");
    driven.take(robots.back());
    motions.push_back(driven.motions);
  }
  for (const auto& length : lengths) {
    Nees mean;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const auto nees = neesOf(robots[i], motions[i], length.motions);
      mean.of_pose += nees.of_pose / kSeeds;
      mean.of_heading += nees.of_heading / kSeeds;
    }
    std::printf("pieces of %5.2f s: NEES %.2f of 3, of the heading %.2f of 1\n",
                0.025 * static_cast<double>(length.motions), mean.of_pose, mean.of_heading);
    EXPECT_GE(mean.of_pose, length.least) << length.motions;
    EXPECT_LE(mean.of_pose, length.most) << length.motions;
    EXPECT_GE(mean.of_heading, length.least_of_heading) << length.motions;
    EXPECT_LE(mean.of_heading, 1.5) << length.motions;
  }
}

}  // namespace
}  // namespace slam::imu_odometry
