// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam {

void CameraConfig::describe(Fields& fields) {
  fields
      .add("sensor_pose", &sensor_pose,
           "[x, y, z, roll, pitch, yaw] of the optical frame in the base frame, instead of the "
           "transform that the robot publishes")
      .unit("m, rad")
      .ofRobot();
}

std::optional<Eigen::Isometry3d> CameraConfig::mount(const std::string& section) const {
  if (sensor_pose.empty()) return std::nullopt;
  if (sensor_pose.size() != 6)
    throw ConfigError(section + ".sensor_pose: it has " + std::to_string(sensor_pose.size()) +
                      " values; it needs 6, [x, y, z, roll, pitch, yaw]");
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return Eigen::Translation3d(sensor_pose[0], sensor_pose[1], sensor_pose[2]) *
         AngleAxisd(sensor_pose[5], Vector3d::UnitZ()) *
         AngleAxisd(sensor_pose[4], Vector3d::UnitY()) *
         AngleAxisd(sensor_pose[3], Vector3d::UnitX());
}

}  // namespace slam
