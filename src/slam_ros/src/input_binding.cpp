// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/input_binding.hpp"

#include "slam_core/imu/imu_config.hpp"
#include "slam_core/laser/laser_config.hpp"

namespace slam_ros {

InputContext inputContext(const ros::NodeHandle& handle, slam::Settings& settings,
                          const InputOptions& options) {
  InputContext context;
  context.handle = handle;
  context.topics = settings.read<TopicsConfig>();
  context.frames = settings.read<slam::FramesConfig>();
  context.has_laser_mount = !settings.read<slam::LaserConfig>().sensor_pose.empty();
  context.has_imu_mount = !settings.read<slam::ImuConfig>().sensor_pose.empty();
  context.options = options;
  return context;
}

}  // namespace slam_ros
