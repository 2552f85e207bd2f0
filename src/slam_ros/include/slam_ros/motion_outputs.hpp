// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <optional>
#include <string>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/edge_watch.hpp"
#include "slam_ros/motion_publisher.hpp"
#include "slam_ros/odometry_nodelet_config.hpp"
#include "slam_ros/transform_publisher.hpp"

namespace slam_ros {

/// Publishes the motions of a source that has an odometry frame of its own: for the back-end, as
/// the transform odom -> base_link unless another node publishes it, and for display.
class MotionOutputs {
 public:
  using Warn = std::function<void(const std::string&)>;

  /// @param source outlives this; it may draw what it sees
  MotionOutputs(ros::NodeHandle handle, const OdometryNodeletConfig& config,
                const slam::FramesConfig& frames, const slam::OdometrySource& source,
                std::string motion_topic, Warn warn);

  /// From here on motions are published for the back-end, where it takes them.
  void advertise();
  void publish(slam::Motion motion);
  /// To be called when time starts over.
  void reset() { transform_.reset(); }

 private:
  bool isEdgeTaken();
  /// Where another node publishes odom -> base.
  std::string ownFrame() const;

  ros::NodeHandle handle_;
  OdometryNodeletConfig config_;
  slam::FramesConfig frames_;
  const slam::OdometrySource& source_;
  std::string motion_topic_;
  Warn warn_;
  bool warned_of_edge_ = false;
  ros::Publisher motion_;
  MotionPublisher shown_;
  TransformPublisher transform_;
  std::optional<EdgeWatch> watch_;
};

}  // namespace slam_ros
