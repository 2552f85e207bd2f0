// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sensor_msgs/LaserScan.h>

#include <functional>
#include <string>

#include "slam_core/laser/laser_sweep.hpp"
#include "slam_ros/sensor_mount.hpp"

namespace slam_ros {

/// Turns the messages of a laser into the inputs of a component; nodelets and slam_offline share
/// it. The mount is passed on when it comes and when it changes. The component holds the scans
/// until it has it, so that the order of arrival does not matter.
class LaserInput {
 public:
  struct Sinks {
    std::function<void(const slam::LaserSweep&)> scan;
    std::function<void(const slam::LaserMount&)> mount;
  };

  /// @param base_frame of the robot
  LaserInput(std::string base_frame, Sinks sinks);

  void take(const sensor_msgs::LaserScan& message);
  void take(const tf2_msgs::TFMessage& static_transforms) { mount_.take(static_transforms); }

  bool hasScan() const { return mount_.hasFrame(); }
  /// "base_link -> laser" while scans came and that transform did not, else empty.
  std::string missingTransform() const { return mount_.missing(); }

 private:
  Sinks sinks_;
  SensorMount mount_;
};

}  // namespace slam_ros
