// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/config_fields.hpp"

namespace slam {

/// What the robot file says of the camera.
struct CameraConfig {
  static constexpr const char* kSection = "camera";

  std::vector<double> sensor_pose;

  void describe(Fields& fields);
  /// The pose of the optical frame in the robot's base frame, where the robot file gives it.
  /// @param section it was read from
  /// @throw ConfigError when it has another number of values than none or 6
  std::optional<Eigen::Isometry3d> mount(const std::string& section = kSection) const;
};

/// The same of the second camera, wherever it looks.
struct RearCameraConfig : CameraConfig {
  static constexpr const char* kSection = "rear_camera";
};

/// The same of the camera that looks at the ceiling.
struct CeilingCameraConfig : CameraConfig {
  static constexpr const char* kSection = "ceiling_camera";

  double ceiling_height = 0.0;

  void describe(Fields& fields);
};

}  // namespace slam
