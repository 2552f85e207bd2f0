// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "messages.hpp"

#include <std_msgs/String.h>

#include <cmath>

namespace slam::eval {

ros::Time toTime(std::int64_t stamp) {
  ros::Time time;
  return time.fromNSec(static_cast<std::uint64_t>(stamp));
}

geometry_msgs::Pose toPose(double x, double y, double theta) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.orientation.z = std::sin(theta / 2.0);
  pose.orientation.w = std::cos(theta / 2.0);
  return pose;
}

nav_msgs::Odometry makeOdometry(std::int64_t stamp) {
  nav_msgs::Odometry message;
  message.header.stamp = toTime(stamp);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose = toPose(0.0, 0.0, 0.0);
  return message;
}

geometry_msgs::PoseStamped makeTruthPose(std::int64_t stamp, double x, double y, double theta) {
  geometry_msgs::PoseStamped message;
  message.header.stamp = toTime(stamp);
  message.header.frame_id = "world";
  message.pose = toPose(x, y, theta);
  return message;
}

slam_msgs::Landmark makeTruthLandmark(std::int64_t id, double x, double y) {
  slam_msgs::Landmark landmark;
  landmark.id = id;
  landmark.x = x;
  landmark.y = y;
  return landmark;
}

slam_msgs::LandmarkMap makeTruthMap() {
  slam_msgs::LandmarkMap map;
  map.header.frame_id = "world";
  return map;
}

void addRobotName(BagWriter& bag, const std::string& robot) {
  std_msgs::String message;
  message.data = robot;
  bag.addFirst("/robot", message);
}

}  // namespace slam::eval
