// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/config_fields.hpp"

namespace slam {

/// What the robot file says of the laser.
struct LaserConfig {
  static constexpr const char* kSection = "laser";

  std::vector<double> sensor_pose;
  double range_max = 0.0;
  double relative_sigma = 0.0;

  void describe(Fields& fields);
  /// The pose of the laser's frame in the robot's base frame, where the robot file gives it.
  /// @param section it was read from
  /// @throw ConfigError when it has another number of values than none or 6
  std::optional<Eigen::Isometry3d> mount(const std::string& section = kSection) const;
};

/// The second laser has the same parameters, wherever it looks.
struct RearLaserConfig : LaserConfig {
  static constexpr const char* kSection = "rear_scan";
};

}  // namespace slam
