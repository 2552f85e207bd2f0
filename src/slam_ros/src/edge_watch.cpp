// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/edge_watch.hpp"

#include <ros/this_node.h>

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

EdgeWatch::EdgeWatch(ros::NodeHandle handle, std::string parent, std::string child)
    : parent_(std::move(parent)), child_(std::move(child)) {
  handle.setCallbackQueue(&queue_);
  transforms_ = handle.subscribe("/tf", 100, &EdgeWatch::onTransforms, this);
  spinner_.start();
}

void EdgeWatch::onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
  if (isTaken() || event.getPublisherName() == ros::this_node::getName()) return;
  for (const auto& transform : event.getMessage()->transforms) {
    if (frameId(transform.header.frame_id) != parent_ ||
        frameId(transform.child_frame_id) != child_)
      continue;
    publisher_ = event.getPublisherName();
    is_taken_ = true;
    return;
  }
}

}  // namespace slam_ros
