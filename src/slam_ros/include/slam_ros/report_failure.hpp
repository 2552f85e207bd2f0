// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/console.h>

#include <exception>
#include <string>

namespace slam_ros {

/// Runs a nodelet's initialisation. An exception is reported before it is passed on to the loader,
/// which would only say that the nodelet was not loaded.
template <class Action>
void reportFailure(const std::string& name, Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM_NAMED("slam", name << ": " << error.what());
    throw;
  }
}

}  // namespace slam_ros
