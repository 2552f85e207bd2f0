// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/transform_publisher.hpp"

#include "slam_ros/conversions.hpp"

namespace slam_ros {

void TransformPublisher::publish(const ros::Time& stamp, const std::string& parent,
                                 const std::string& child, const slam::Pose2& T_parent_child) {
  if (last_ && stamp <= *last_) return;
  last_ = stamp;
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = frameId(parent);
  message.child_frame_id = frameId(child);
  message.transform = toTransformMsg(T_parent_child);
  broadcaster_.sendTransform(message);
}

}  // namespace slam_ros
