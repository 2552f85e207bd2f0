// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/parameters_from_ros.hpp"

#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {

slam::ConfigDocument privateParameters(const ros::NodeHandle& private_handle) {
  const auto name = private_handle.getNamespace();
  YAML::Node root(YAML::NodeType::Map);
  XmlRpc::XmlRpcValue value;
  if (private_handle.getParam(name, value)) root = toYaml(value);
  root.remove("diagnostic_period");  // the diagnostic updater's own
  root["version"] = slam::Settings::kVersion;
  return {"the parameters of " + name, root};
}

}  // namespace slam_ros
