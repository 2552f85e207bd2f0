// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/module_publisher.hpp"

namespace slam_ros {

ModulePublishers& ModulePublishers::instance() {
  static ModulePublishers publishers;
  return publishers;
}

std::unique_ptr<ModulePublisher> ModulePublishers::create(
    const slam::MapModule& module, const ModulePublisher::Context& context) const {
  for (const auto& factory : factories_)
    if (auto publisher = factory(module, context)) return publisher;
  return nullptr;
}

}  // namespace slam_ros
