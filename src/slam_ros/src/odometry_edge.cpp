// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/odometry_edge.hpp"

#include <algorithm>
#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

nav_msgs::Odometry toOdometry(const geometry_msgs::TransformStamped& edge) {
  nav_msgs::Odometry message;
  message.header = edge.header;
  message.child_frame_id = edge.child_frame_id;
  message.pose.pose.position.x = edge.transform.translation.x;
  message.pose.pose.position.y = edge.transform.translation.y;
  message.pose.pose.position.z = edge.transform.translation.z;
  message.pose.pose.orientation = edge.transform.rotation;
  return message;
}

}  // namespace

bool holdsTransforms(const BagTopic& topic) {
  return topic.messages > 0 &&
         topic.md5sum == ros::message_traits::MD5Sum<tf2_msgs::TFMessage>::value();
}

OdometryEdge::OdometryEdge(std::string odom_frame, std::string base_frame)
    : odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

bool OdometryEdge::leads(const geometry_msgs::TransformStamped& edge) const {
  return frameId(edge.header.frame_id) == odom_frame_ &&
         frameId(edge.child_frame_id) == base_frame_;
}

bool OdometryEdge::isIn(const tf2_msgs::TFMessage& message) const {
  return std::any_of(message.transforms.begin(), message.transforms.end(),
                     [this](const auto& edge) { return leads(edge); });
}

void OdometryEdge::take(const tf2_msgs::TFMessage& message,
                        const std::function<void(const nav_msgs::Odometry&)>& sink) {
  for (const auto& edge : message.transforms) {
    if (!leads(edge) || edge.header.stamp == last_) continue;
    last_ = edge.header.stamp;
    sink(toOdometry(edge));
  }
}

}  // namespace slam_ros
