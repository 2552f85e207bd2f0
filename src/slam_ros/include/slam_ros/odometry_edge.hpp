// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>

#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// Whether a topic of a bag is a /tf. The old tf/tfMessage has the same layout, hence the same
/// checksum.
bool holdsTransforms(const BagTopic& topic);

/// Takes the transform odom -> base of a /tf as odometry, for robots that publish their odometry
/// only in this way. A transform that is sent again with the same stamp is ignored.
class OdometryEdge {
 public:
  /// The frames are without a leading slash.
  OdometryEdge(std::string odom_frame, std::string base_frame);

  bool isIn(const tf2_msgs::TFMessage& message) const;

  void take(const tf2_msgs::TFMessage& message,
            const std::function<void(const nav_msgs::Odometry&)>& sink);

 private:
  bool leads(const geometry_msgs::TransformStamped& edge) const;

  std::string odom_frame_, base_frame_;
  ros::Time last_;
};

}  // namespace slam_ros
