// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <optional>
#include <string>

#include "slam_core/geometry/jump_limit.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_ros/edge_watch.hpp"
#include "slam_ros/outputs_config.hpp"
#include "slam_ros/transform_publisher.hpp"

namespace slam_ros {

/// Publishes `map -> odom`, computed from the estimate and the odometry pose of the same stamp: at
/// every step, and in between at a constant rate of the ROS clock, stamped ahead by the tolerance.
/// In a product without motion the odometry pose is what another node publishes as `odom -> base`;
/// if no node has done so for a second, this one publishes `odom -> base` as the identity.
///
/// A limit spreads the movement by corrections of the estimate over the next steps. If the pose of
/// the robot was set, or if it started over, the transform jumps.
class MapOdomBroadcaster {
 public:
  MapOdomBroadcaster(ros::NodeHandle handle, std::string map_frame, const OutputsConfig& config,
                     const slam::JumpLimit::Limits& limits);

  /// Sets rate and tolerance.
  void configure(const OutputsConfig& config);
  void update(const slam::StepReport& report);
  /// Sends nothing until the next step.
  void reset();

 private:
  /// Computes `map -> odom` of a step without motion.
  void updateWithoutMotion(const slam::StepReport& report);
  void sendIfDue(slam::Stamp now);
  void send(slam::Stamp now);

  ros::NodeHandle handle_;
  std::string map_frame_, odometry_frame_;
  std::string base_frame_;          ///< in a product without motion whose edge nobody publishes
  std::optional<EdgeWatch> watch_;  ///< in a product without motion
  slam::Duration interval_{}, tolerance_{};
  std::optional<slam::Stamp> due_;  ///< of the ROS clock
  slam::JumpLimit limit_;
  slam::Pose2 T_map_odom_;
  TransformPublisher publisher_, base_publisher_;
  // A timer of the ROS clock ends the process where that clock nears its last second.
  ros::WallTimer poll_;
};

}  // namespace slam_ros
