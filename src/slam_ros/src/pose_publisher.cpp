// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/pose_publisher.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {

PosePublisher::PosePublisher(ros::NodeHandle handle, std::string map_frame, double path_rate)
    : map_frame_(std::move(map_frame)),
      pose_(handle.advertise<geometry_msgs::PoseWithCovarianceStamped>("pose", kQueue)),
      path_publisher_(handle.advertise<nav_msgs::Path>("path", 1)),
      rate_(path_rate),
      path_(map_frame_) {}

void PosePublisher::publish(const slam::StepReport& report) {
  const auto message = toMsg(report.pose, report.stamp, map_frame_);
  // by pointer: a subscriber in this process has it before what follows
  pose_.publish(boost::make_shared<const geometry_msgs::PoseWithCovarianceStamped>(message));

  geometry_msgs::PoseStamped last;
  last.header = message.header;
  last.pose = message.pose.pose;
  path_.add(last);
  path_is_new_ = true;
  if (rate_.isDue(report.stamp)) flush();
}

void PosePublisher::flush() {
  const auto subscribers = path_publisher_.getNumSubscribers();
  if (subscribers > 0 && (path_is_new_ || subscribers > subscribers_)) {
    path_publisher_.publish(path_.message());
    path_is_new_ = false;
  }
  subscribers_ = subscribers;
}

void PosePublisher::reset() {
  path_ = ThinnedPath(map_frame_);
  path_is_new_ = true;
}

}  // namespace slam_ros
