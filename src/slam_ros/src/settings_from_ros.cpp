// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/settings_from_ros.hpp"

#include <fmt/format.h>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/map_folder.hpp"

namespace slam_ros {
namespace {

YAML::Node structToYaml(XmlRpc::XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Map);
  for (auto& entry : value) node[entry.first] = toYaml(entry.second);
  return node;
}

YAML::Node listToYaml(XmlRpc::XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i) node.push_back(toYaml(value[i]));
  return node;
}

slam::ConfigDocument document(const ros::NodeHandle& handle, const std::string& name) {
  const auto parameter = handle.resolveName(name);
  XmlRpc::XmlRpcValue value;
  if (!handle.getParam(name, value))
    throw slam::ConfigError("the parameter " + parameter + " is missing; load a " + name +
                            " file into it, as slam.launch does");
  return {"parameter " + parameter, toYaml(value)};
}

std::vector<std::string> overrides(const ros::NodeHandle& handle) {
  XmlRpc::XmlRpcValue value;
  if (!handle.getParam("overrides", value)) return {};
  std::vector<std::string> entries;
  if (!YAML::convert<std::vector<std::string>>::decode(toYaml(value), entries))
    throw slam::ConfigError("the parameter " + handle.resolveName("overrides") +
                            " is not a list of texts like section.key=value");
  return entries;
}

}  // namespace

YAML::Node toYaml(XmlRpc::XmlRpcValue& value) {
  using XmlRpc::XmlRpcValue;
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value) ? "true" : "false");
    case XmlRpcValue::TypeInt:
      return YAML::Node(std::to_string(static_cast<int>(value)));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(fmt::format("{}", static_cast<double>(value)));
    case XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string&>(value));
    case XmlRpcValue::TypeStruct:
      return structToYaml(value);
    case XmlRpcValue::TypeArray:
      return listToYaml(value);
    default:
      throw slam::ConfigError("a parameter is of a type that a configuration file does not hold");
  }
}

slam::Settings settingsFromRos(const ros::NodeHandle& handle) {
  slam::Settings settings(document(handle, "product"), document(handle, "robot"),
                          overrides(handle));
  settings.read<FilesConfig>();  // of every process of a product, whoever uses it
  return settings;
}

std::string robotFileFromRos(const ros::NodeHandle& handle) {
  return YAML::Dump(document(handle, "robot").root) + "\n";
}

}  // namespace slam_ros
