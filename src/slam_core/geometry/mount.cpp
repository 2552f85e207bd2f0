// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/mount.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam {

std::string faultOfMount(const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Matrix3d R = T_base_sensor.linear();
  if (!T_base_sensor.matrix().allFinite()) return "it holds a value that is not a number";
  if (!(R * R.transpose()).isIdentity(1e-6) || R.determinant() < 0.0)
    return "its rotation is no rotation";
  return "";
}

std::optional<Eigen::Isometry3d> mountOf(const std::vector<double>& sensor_pose,
                                         const std::string& field) {
  if (sensor_pose.empty()) return std::nullopt;
  if (sensor_pose.size() != 6)
    throw ConfigError(field + ": it has " + std::to_string(sensor_pose.size()) +
                      " values; it needs 6, [x, y, z, roll, pitch, yaw]");
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return Eigen::Translation3d(sensor_pose[0], sensor_pose[1], sensor_pose[2]) *
         AngleAxisd(sensor_pose[5], Vector3d::UnitZ()) *
         AngleAxisd(sensor_pose[4], Vector3d::UnitY()) *
         AngleAxisd(sensor_pose[3], Vector3d::UnitX());
}

}  // namespace slam
