// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "slam_core/common/config_fields.hpp"

namespace slam {

/// What the robot file says of the IMU. The defaults are those of a cheap MEMS gyro.
struct ImuConfig {
  static constexpr const char* kSection = "imu";

  enum class Units { kRadians, kDegrees };

  std::vector<double> sensor_pose;
  Units units = Units::kRadians;
  double gyro_noise = 3e-4;
  double bias_sigma = 0.01;
  double bias_random_walk = 2e-5;
  double scale_sigma = 0.01;

  void describe(Fields& fields);
  /// The pose of the IMU's frame in the robot's base frame, where the robot file gives it.
  /// @throw ConfigError when it has another number of values than none or 6
  std::optional<Eigen::Isometry3d> mount() const;
};

}  // namespace slam
