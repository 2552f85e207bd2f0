// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/input_binding.hpp"

namespace slam_ros {

InputContext inputContext(const ros::NodeHandle& handle, slam::Settings& settings,
                          const InputOptions& options) {
  InputContext context;
  context.handle = handle;
  context.topics = settings.read<TopicsConfig>();
  context.frames = settings.read<slam::FramesConfig>();
  context.mounts = GivenMounts(settings);
  context.options = options;
  return context;
}

}  // namespace slam_ros
