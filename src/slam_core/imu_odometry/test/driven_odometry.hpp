// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "slam_core/contract/registry.hpp"
#include "slam_core/gyro/test/turning_robot.hpp"
#include "slam_core/imu_odometry/wheel_imu_odometry.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam::imu_odometry::test {

using gyro::test::GyroErrors;
using gyro::test::Leg;
using gyro::test::someDrive;
using gyro::test::TurningRobot;
using gyro::test::WheelErrors;

inline Settings robotSettings(const std::string& robot) {
  return Settings({"product", YAML::Load("{version: 1}")},
                  {"robot", YAML::Load(robot.empty() ? "{version: 1}" : robot)}, {});
}

/// Gives an odometry what a robot measures and keeps what comes of it.
class DrivenOdometry {
 public:
  explicit DrivenOdometry(const std::string& robot = "") {
    loadLibraries({});
    auto settings = robotSettings(robot);
    odometry.configure(settings);
  }

  template <class Sample>
  void take(const Sample& sample) {
    odometry.set(sample);
    do {
      const auto status = odometry.execute();
      if (!status.isOk()) messages.push_back(status.message);
      if (odometry.motion()) motions.push_back(*odometry.motion());
    } while (odometry.isBusy());
  }

  /// Gives wheels and gyro in the order of their stamps, as they come live.
  void take(const std::vector<OdometrySample>& wheels, const std::vector<ImuSample>& gyro) {
    auto sample = gyro.begin();
    for (const auto& of_wheels : wheels) {
      for (; sample != gyro.end() && sample->stamp <= of_wheels.stamp; ++sample) take(*sample);
      take(of_wheels);
    }
    for (; sample != gyro.end(); ++sample) take(*sample);
  }
  void take(const TurningRobot& robot) { take(robot.wheels(), robot.gyro()); }

  /// Whether something was said that holds these words.
  bool said(const std::string& words) const {
    return std::any_of(messages.begin(), messages.end(), [&](const auto& message) {
      return message.find(words) != std::string::npos;
    });
  }
  /// The sum of all motions since the first one.
  Pose2 pose() const {
    Pose2 pose;
    for (const auto& motion : motions) pose = pose * motion.increment;
    return pose;
  }

  WheelImuOdometry odometry;
  std::vector<Motion> motions;
  std::vector<std::string> messages;
};

/// The error of the heading at the end [rad].
inline double headingError(const DrivenOdometry& driven, const TurningRobot& robot) {
  return robot.truth()[driven.motions.size()].pose.between(driven.pose()).theta();
}

}  // namespace slam::imu_odometry::test
