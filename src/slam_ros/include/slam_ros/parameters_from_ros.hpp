// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <string>

#include "slam_core/common/settings.hpp"

namespace slam_ros {

/// The private parameters of a nodelet as a document for slam::Settings.
slam::ConfigDocument privateParameters(const ros::NodeHandle& private_handle);

/// A nodelet's private parameters as a struct with describe(), whose kSection is "".
/// @throw slam::ConfigError listing unknown parameters, wrong types and values out of range
template <class Config>
Config parametersFromRos(const ros::NodeHandle& private_handle) {
  return slam::Settings(privateParameters(private_handle), {}, {}).template read<Config>();
}

}  // namespace slam_ros
