// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "decision_publisher.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Bool.h>
#include <visualization_msgs/MarkerArray.h>

#include "decision_markers.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_active {

using slam::active_path::Decision;

DecisionPublisher::DecisionPublisher(ros::NodeHandle handle)
    : goal_(handle.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1, true)),
      way_(handle.advertise<nav_msgs::Path>("active_path/way", 1, true)),
      markers_(handle.advertise<visualization_msgs::MarkerArray>("active_path/markers", 1, true)),
      explored_(handle.advertise<std_msgs::Bool>("explored", 1, true)) {
  publishExplored(false);
}

void DecisionPublisher::publish(const Decision& decision, double resolution,
                                const std_msgs::Header& header) {
  if (decision.goal && decision.is_new) publishGoal(*decision.goal, header);
  publishWay(decision, header);
  if (markers_.getNumSubscribers() > 0) markers_.publish(toMarkers(decision, resolution, header));
  const bool is_explored = decision.state == Decision::State::kExplored;
  if (is_explored != is_explored_) publishExplored(is_explored);
}

void DecisionPublisher::publishGoal(const slam::active_path::Goal& goal,
                                    const std_msgs::Header& header) {
  geometry_msgs::PoseStamped message;
  message.header = header;
  message.pose = slam_ros::toSpatialMsg(goal.pose);
  goal_.publish(message);
}

void DecisionPublisher::publishWay(const Decision& decision, const std_msgs::Header& header) {
  nav_msgs::Path message;
  message.header = header;
  for (const auto& place : decision.way) {
    auto& pose = message.poses.emplace_back();
    pose.header = header;
    pose.pose = slam_ros::toSpatialMsg({place.x(), place.y(), 0.0});
  }
  if (decision.goal) message.poses.back().pose = slam_ros::toSpatialMsg(decision.goal->pose);
  way_.publish(message);
}

void DecisionPublisher::publishExplored(bool is_explored) {
  is_explored_ = is_explored;
  std_msgs::Bool message;
  message.data = is_explored;
  explored_.publish(message);
}

}  // namespace slam_active
