// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/product/estimator.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// `pose` at every step; `path`, which grows, at a bounded rate.
class PosePublisher {
 public:
  PosePublisher(ros::NodeHandle handle, std::string map_frame, double path_rate);

  void publish(const slam::StepReport& report);
  /// What the rate held back, and for those who have subscribed since.
  void flush();
  /// The path begins anew.
  void reset();

 private:
  std::string map_frame_;
  ros::Publisher pose_, path_publisher_;
  RateLimit rate_;
  nav_msgs::Path path_;
  bool path_is_new_ = false;
  std::uint32_t subscribers_ = 0;
};

}  // namespace slam_ros
