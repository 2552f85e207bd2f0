// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/edge_watch.hpp"

#include <ros/this_node.h>

#include <algorithm>
#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr std::size_t kKept = 200;  // edges: some seconds of a driver's

slam::StampedPose edgeOf(const geometry_msgs::TransformStamped& message) {
  geometry_msgs::Pose pose;
  pose.position.x = message.transform.translation.x;
  pose.position.y = message.transform.translation.y;
  pose.orientation = message.transform.rotation;
  return {fromRos(message.header.stamp), fromMsg(pose)};
}

}  // namespace

EdgeWatch::EdgeWatch(ros::NodeHandle handle, std::string parent, std::string child)
    : parent_(std::move(parent)), child_(std::move(child)) {
  handle.setCallbackQueue(&queue_);
  transforms_ = handle.subscribe("/tf", 100, &EdgeWatch::onTransforms, this);
  spinner_.start();
}

void EdgeWatch::onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  for (const auto& transform : event.getMessage()->transforms) {
    if (frameId(transform.header.frame_id) != parent_ ||
        frameId(transform.child_frame_id) != child_)
      continue;
    keep(edgeOf(transform));
    if (!isTaken()) publisher_ = event.getPublisherName();
    is_taken_ = true;
  }
}

/// Time that goes back begins anew.
void EdgeWatch::keep(const slam::StampedPose& edge) {
  if (!edge.pose.isFinite()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!edges_.empty() && edge.stamp < edges_.back().stamp) edges_.clear();
  edges_.push_back(edge);
  if (edges_.size() > kKept) edges_.pop_front();
}

std::optional<slam::Pose2> EdgeWatch::at(slam::Stamp stamp) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto after = std::upper_bound(
      edges_.begin(), edges_.end(), stamp,
      [](slam::Stamp sought, const slam::StampedPose& edge) { return sought < edge.stamp; });
  if (after == edges_.begin()) return std::nullopt;
  const auto& before = *std::prev(after);
  if (after == edges_.end()) return before.pose;
  const double share =
      slam::seconds(stamp - before.stamp) / slam::seconds(after->stamp - before.stamp);
  return before.pose * before.pose.between(after->pose).part(share);
}

}  // namespace slam_ros
