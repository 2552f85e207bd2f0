// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/given_mounts.hpp"

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/imu/imu_config.hpp"
#include "slam_core/laser/laser_config.hpp"

namespace slam_ros {

GivenMounts::GivenMounts(slam::Settings settings) {
  const auto add = [this](const std::string& port, const std::vector<double>& sensor_pose) {
    if (!sensor_pose.empty()) ports_.insert(port);
  };
  add("scan", settings.read<slam::LaserConfig>().sensor_pose);
  add("rear_scan", settings.read<slam::RearLaserConfig>().sensor_pose);
  add("imu", settings.read<slam::ImuConfig>().sensor_pose);
  add("camera", settings.read<slam::CameraConfig>().sensor_pose);
  add("rear_camera", settings.read<slam::RearCameraConfig>().sensor_pose);
  add("ceiling_camera", settings.read<slam::CeilingCameraConfig>().sensor_pose);
}

}  // namespace slam_ros
