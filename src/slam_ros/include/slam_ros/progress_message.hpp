// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Progress.h>

#include <map>
#include <string>

#include "slam_core/common/time.hpp"

namespace slam_ros {

/// The name of an input in slam_msgs/Progress: "scans" for `scan`, after the field of that name.
std::string progressName(const std::string& input);

/// Sets how far an input has arrived.
void setProgress(slam_msgs::Progress& message, const std::string& input, slam::Stamp newest);

/// The newest stamp of each input in the message, by progressName().
std::map<std::string, slam::Stamp> progressOf(const slam_msgs::Progress& message);

}  // namespace slam_ros
