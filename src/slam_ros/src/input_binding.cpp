// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/input_binding.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_core/laser/laser_config.hpp"

namespace slam_ros {

InputBindings& InputBindings::instance() {
  static InputBindings bindings;
  return bindings;
}

InputContext inputContext(const ros::NodeHandle& handle, slam::Settings& settings,
                          const InputOptions& options) {
  InputContext context;
  context.handle = handle;
  context.topics = settings.read<TopicsConfig>();
  context.frames = settings.read<slam::FramesConfig>();
  context.has_laser_mount = !settings.read<slam::LaserConfig>().sensor_pose.empty();
  context.options = options;
  return context;
}

std::vector<std::string> InputBindings::kinds() const {
  std::vector<std::string> kinds;
  for (const auto& entry : factories_) kinds.push_back(slam::nameOf(entry.first));
  std::sort(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  return kinds;
}

std::unique_ptr<InputBinding> InputBindings::create(const InputContext& context,
                                                    const slam::InputPort& port) const {
  const auto count = factories_.count(port.kind);
  if (count == 1) return factories_.find(port.kind)->second(context, port);
  const auto input = "the input '" + port.name + "' (" + slam::nameOf(port.kind) + ")";
  if (count > 1)
    throw slam::ConfigError(std::to_string(count) + " bindings bring data for " + input +
                            "; leave all but one of their libraries out of the product");
  throw slam::ConfigError("nobody makes data for " + input +
                          ", and no binding brings them from a topic; there are bindings for " +
                          slam::join(kinds()) +
                          ": name the library that has one in the product's `libraries`");
}

}  // namespace slam_ros
