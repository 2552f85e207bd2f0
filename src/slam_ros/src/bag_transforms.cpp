// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_transforms.hpp"

#include <ros/message_traits.h>

#include <map>

#include "slam_ros/conversions.hpp"
#include "slam_ros/odometry_edge.hpp"

namespace slam_ros {
namespace {

bool leads(const geometry_msgs::TransformStamped& edge, const std::string& parent,
           const std::string& child) {
  return frameId(edge.header.frame_id) == parent && frameId(edge.child_frame_id) == child;
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
    const OdometryEdge edge(odom_frame, base_frame);
    const auto look = [&](const tf2_msgs::TFMessage& message) {
      found = found || edge.isIn(message);
    };
    bag.read({{topic.name, onMessage<tf2_msgs::TFMessage>(look)}},
             [&](std::size_t) { return !found; });
    if (found) return topic.name;
  }
  return "";
}

BagHandler odometryOfEdge(const std::string& odom_frame, const std::string& base_frame,
                          const std::function<void(const nav_msgs::Odometry&)>& sink) {
  return onMessage<tf2_msgs::TFMessage>(
      [edge = OdometryEdge(odom_frame, base_frame),
       sink](const tf2_msgs::TFMessage& message) mutable { edge.take(message, sink); });
}

}  // namespace slam_ros
