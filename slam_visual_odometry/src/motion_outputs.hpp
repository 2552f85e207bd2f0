// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <optional>
#include <string>

#include "edge_watch.hpp"
#include "nodelet_config.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/motion_publisher.hpp"
#include "slam_ros/transform_publisher.hpp"

namespace slam_visual_odometry {

/// Publishes motions: for the back-end, as the transform odom -> base_link unless another node does
/// that, and to look at.
class MotionOutputs {
 public:
  using Warn = std::function<void(const std::string&)>;

  MotionOutputs(ros::NodeHandle handle, const NodeletConfig& config,
                const slam::FramesConfig& frames, const std::string& motion_topic, Warn warn);

  /// @param source that has made the motion; it may have drawn what it saw
  void publish(slam::Motion motion, const slam::OdometrySource* source);
  /// Time begins anew.
  void reset() { transform_.reset(); }

 private:
  bool isEdgeTaken();

  NodeletConfig config_;
  slam::FramesConfig frames_;
  Warn warn_;
  bool warned_of_edge_ = false;
  ros::Publisher motion_;
  slam_ros::VisualMotionPublisher shown_;
  slam_ros::TransformPublisher transform_;
  std::optional<EdgeWatch> watch_;
};

}  // namespace slam_visual_odometry
