// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <string>

#include "slam_core/common/settings.hpp"

namespace slam_ros {

/// A ROS parameter as the YAML from which it was loaded; numbers keep every digit.
/// @throw slam::ConfigError for a type that YAML files do not hold (binary data, a date)
YAML::Node toYaml(XmlRpc::XmlRpcValue& value);

/// The parameters `product`, `robot` (the contents of the two files) and `overrides` (a list of
/// "section.key=value") of a namespace.
/// @throw slam::ConfigError if one is missing or malformed
slam::Settings settingsFromRos(const ros::NodeHandle& handle);
/// The text of the robot file, without its comments. @throw as settingsFromRos()
std::string robotFileFromRos(const ros::NodeHandle& handle);

}  // namespace slam_ros
