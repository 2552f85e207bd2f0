// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/random.hpp"
#include "slam_sim/robot_model.hpp"
#include "slam_sim/sensors.hpp"

namespace slam::sim {

/// The gyro of an IMU: a bias that walks at random, white noise, a scale (IEEE Std 952).
class Gyroscope {
 public:
  Gyroscope() = default;
  explicit Gyroscope(const ImuModel& imu) : imu_(imu), bias_(imu.gyro_bias) {}

  /// The next reading, in the IMU's frame [rad/s]. @param turn_rate of the base about +z [rad/s]
  Eigen::Vector3d measure(double turn_rate, RandomStream& random);

 private:
  ImuModel imu_;
  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
};

/// The base's turn rate at the path's second 0 [rad/s].
double turnRate(const BasePath& T_world_base);

}  // namespace slam::sim
