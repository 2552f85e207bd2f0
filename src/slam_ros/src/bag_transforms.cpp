// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_transforms.hpp"

#include <ros/message_traits.h>

#include <map>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

bool leads(const geometry_msgs::TransformStamped& edge, const std::string& parent,
           const std::string& child) {
  return frameId(edge.header.frame_id) == parent && frameId(edge.child_frame_id) == child;
}

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

/// The old tf/tfMessage has the same layout, hence the same sum.
bool holdsTransforms(const BagTopic& topic) {
  return topic.messages > 0 &&
         topic.md5sum == ros::message_traits::MD5Sum<tf2_msgs::TFMessage>::value();
}

tf2_msgs::TFMessage withoutMap(const tf2_msgs::TFMessage& message, const std::string& map_frame) {
  tf2_msgs::TFMessage kept;
  for (const auto& edge : message.transforms)
    if (frameId(edge.header.frame_id) != map_frame) kept.transforms.push_back(edge);
  return kept;
}

tf2_msgs::TFMessage withoutEdge(const tf2_msgs::TFMessage& message, const std::string& parent,
                                const std::string& child) {
  tf2_msgs::TFMessage kept;
  for (const auto& edge : message.transforms)
    if (!leads(edge, parent, child)) kept.transforms.push_back(edge);
  return kept;
}

tf2_msgs::TFMessage staticTransforms(const BagReader& bag, const std::string& map_frame) {
  tf2_msgs::TFMessage all;
  const auto* topic = bag.find("tf_static");
  if (topic == nullptr || !holdsTransforms(*topic)) return all;
  std::map<std::string, geometry_msgs::TransformStamped> newest;
  const auto take = [&](const tf2_msgs::TFMessage& message) {
    for (const auto& edge : withoutMap(message, map_frame).transforms)
      newest[frameId(edge.child_frame_id)] = edge;
  };
  bag.read({{topic->name, onMessage<tf2_msgs::TFMessage>(take)}});
  for (const auto& entry : newest) all.transforms.push_back(entry.second);
  return all;
}

std::string findOdometryEdge(const BagReader& bag, const std::string& odom_frame,
                             const std::string& base_frame) {
  for (const auto& topic : bag.topics()) {
    if (!sameTopic(topic.name, "tf") || !holdsTransforms(topic)) continue;
    bool found = false;
    const auto look = [&](const tf2_msgs::TFMessage& message) {
      for (const auto& edge : message.transforms)
        found = found || leads(edge, odom_frame, base_frame);
    };
    bag.read({{topic.name, onMessage<tf2_msgs::TFMessage>(look)}},
             [&](std::size_t) { return !found; });
    if (found) return topic.name;
  }
  return "";
}

BagHandler odometryOfEdge(const std::string& odom_frame, const std::string& base_frame,
                          const std::function<void(const nav_msgs::Odometry&)>& sink) {
  return onMessage<tf2_msgs::TFMessage>([odom_frame, base_frame, sink, last = ros::Time()](
                                            const tf2_msgs::TFMessage& message) mutable {
    for (const auto& edge : message.transforms) {
      if (!leads(edge, odom_frame, base_frame) || edge.header.stamp == last) continue;
      last = edge.header.stamp;
      sink(toOdometry(edge));
    }
  });
}

}  // namespace slam_ros
