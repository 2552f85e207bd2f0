// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "estimate_subscriber.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_pointmap {

using slam_ros::kQueue;

EstimateSubscriber::EstimateSubscriber(ros::NodeHandle handle, const std::string& motion_topic,
                                       Sinks sinks)
    : sinks_(std::move(sinks)),
      motion_(handle.subscribe(motion_topic, kQueue, &EstimateSubscriber::onMotion, this)),
      pose_(handle.subscribe("pose", kQueue, &EstimateSubscriber::onPose, this)),
      progress_(handle.subscribe("progress", kQueue, &EstimateSubscriber::onProgress, this)) {}

void EstimateSubscriber::onMotion(const slam_msgs::Motion& message) {
  sinks_.motion(slam_ros::fromMsg(message));
}

void EstimateSubscriber::onPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto& pose = message.pose.pose;
  sinks_.pose({slam_ros::fromRos(message.header.stamp), pose.position.x, pose.position.y,
               pose.orientation.z, pose.orientation.w});
}

void EstimateSubscriber::onProgress(const slam_msgs::Progress& message) {
  if (message.resets != resets_) sinks_.reset();
  resets_ = message.resets;
}

}  // namespace slam_pointmap
