// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/timer.h>

#include <string>

#include "slam_core/product/estimator.hpp"
#include "slam_ros/outputs_config.hpp"
#include "slam_ros/transform_publisher.hpp"

namespace slam_ros {

/// `map -> odom` from the estimate and the odometry pose of the same stamp: at every step, and in
/// between at a constant rate of the ROS clock, stamped ahead by the tolerance.
class MapOdomBroadcaster {
 public:
  MapOdomBroadcaster(ros::NodeHandle handle, std::string map_frame, const OutputsConfig& config);

  void update(const slam::StepReport& report);
  /// Nothing is sent until the next step.
  void reset();

 private:
  void send(const ros::Time& now);

  std::string map_frame_, odometry_frame_;
  ros::Duration tolerance_;
  slam::Pose2 T_map_odom_;
  TransformPublisher publisher_;
  ros::Timer timer_;
};

}  // namespace slam_ros
