// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/edge_watch.hpp"

#include <ros/this_node.h>

#include <algorithm>
#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr slam::Duration kKept = std::chrono::seconds(10);
constexpr std::size_t kMost = 10000;  // edges: of those ten seconds, and of the owner's
constexpr double kSlowest = 1.0;      // [s] between two edges of a driver

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
  const bool is_this_node = event.getPublisherName() == ros::this_node::getName();
  for (const auto& transform : event.getMessage()->transforms) {
    if (frameId(transform.header.frame_id) != parent_ ||
        frameId(transform.child_frame_id) != child_)
      continue;
    const auto edge = edgeOf(transform);
    if (!edge.pose.isFinite() || (is_this_node && isOwn(edge))) continue;
    keep(edge);
    if (!isTaken()) publisher_ = event.getPublisherName();
    is_taken_ = true;
  }
}

void EdgeWatch::noteOwn(const slam::StampedPose& edge) {
  const std::lock_guard<std::mutex> lock(mutex_);
  own_.push_back(edge);
  if (own_.size() > kMost) own_.pop_front();
}

bool EdgeWatch::isOwn(const slam::StampedPose& edge) const {
  constexpr double kRounding = 1e-9;  // [m], [rad]
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(own_.rbegin(), own_.rend(), [&edge](const slam::StampedPose& own) {
    return own.stamp == edge.stamp && own.pose.between(edge.pose).log().norm() < kRounding;
  });
}

bool EdgeWatch::hasListened() const { return (ros::WallTime::now() - began_).toSec() > kSlowest; }

/// Time that goes back starts over; edges that have overtaken one another are put in order.
void EdgeWatch::keep(const slam::StampedPose& edge) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!edges_.empty() && edge.stamp < edges_.back().stamp - kKept) edges_.clear();
  edges_.insert(behind(edge.stamp), edge);
  while (edges_.size() > kMost || edges_.front().stamp < edge.stamp - kKept) edges_.pop_front();
}

std::deque<slam::StampedPose>::const_iterator EdgeWatch::behind(slam::Stamp stamp) const {
  return std::upper_bound(
      edges_.begin(), edges_.end(), stamp,
      [](slam::Stamp sought, const slam::StampedPose& edge) { return sought < edge.stamp; });
}

std::optional<slam::Pose2> EdgeWatch::at(slam::Stamp stamp) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto after = behind(stamp);
  if (after == edges_.begin()) return std::nullopt;
  const auto& before = *std::prev(after);
  if (after == edges_.end()) return before.pose;
  const double share =
      slam::seconds(stamp - before.stamp) / slam::seconds(after->stamp - before.stamp);
  return before.pose * before.pose.between(after->pose).part(share);
}

}  // namespace slam_ros
