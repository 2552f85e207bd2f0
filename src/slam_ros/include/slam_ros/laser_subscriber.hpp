// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <optional>
#include <string>

#include "slam_ros/after_load.hpp"
#include "slam_ros/door.hpp"
#include "slam_ros/laser_input.hpp"

namespace slam_ros {

/// Subscribes a laser once its nodelet is loaded: scans and /tf_static. All callbacks come from the
/// node handle's queue. Its owner calls stop() before what the sinks need goes away.
class LaserSubscriber {
 public:
  struct Options {
    std::string topic;
    std::string base_frame;             ///< of the robot
    bool robot_file_has_mount = false;  ///< else it comes as a transform
  };

  /// @throw ros::InvalidNameException
  /// @param pass of all callbacks
  LaserSubscriber(ros::NodeHandle handle, Options options, LaserInput::Sinks sinks, Pass pass);

  const std::string& topic() const { return options_.topic; }
  /// "waiting for ...", or empty when all have come that are needed.
  std::string waiting() const;
  /// From here on no callback runs.
  void stop();

 private:
  void subscribe(ros::NodeHandle handle);

  Options options_;
  Pass pass_;
  LaserInput input_;
  ros::Subscriber scans_, transforms_;
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros
