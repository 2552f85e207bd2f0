// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_transforms.hpp"

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

}  // namespace slam_ros
