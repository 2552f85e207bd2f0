// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <string>

#include "slam_core/common/settings.hpp"

namespace slam_ros {

/// The sensors whose mounts the robot file gives; the mounts of others come as transforms.
class GivenMounts {
 public:
  GivenMounts() = default;
  /// @param settings a copy, since reading sections here must not count as their use
  /// @throw slam::ConfigError
  explicit GivenMounts(slam::Settings settings);

  /// @param port that takes the sensor's data
  bool has(const std::string& port) const { return ports_.count(port) > 0; }

 private:
  std::set<std::string> ports_;
};

}  // namespace slam_ros
