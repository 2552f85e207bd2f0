// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/landmark_publisher.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

LandmarkPublisher::LandmarkPublisher(ros::NodeHandle handle, const slam::LandmarkMapper& mapper,
                                     std::string map_frame, double rate)
    : mapper_(mapper),
      map_frame_(std::move(map_frame)),
      landmarks_(handle.advertise<slam_msgs::LandmarkMap>("landmarks", 1)),
      marker_publisher_(handle.advertise<visualization_msgs::MarkerArray>("landmark_markers", 1)),
      rate_(rate) {}

void LandmarkPublisher::update(slam::Stamp stamp) {
  stamp_ = stamp;
  is_new_ = true;
  if (rate_.isDue(stamp)) flush();
}

void LandmarkPublisher::flush() {
  const auto subscribers = landmarks_.getNumSubscribers() + marker_publisher_.getNumSubscribers();
  if (subscribers > 0 && (is_new_ || subscribers > subscribers_)) publish();
  subscribers_ = subscribers;
}

void LandmarkPublisher::publish() {
  is_new_ = false;
  const auto map = mapper_.landmarks();
  const auto message = toMsg(map, stamp_, map_frame_);
  landmarks_.publish(message);
  if (marker_publisher_.getNumSubscribers() > 0)
    marker_publisher_.publish(markers_.next(map, message.header));
}

}  // namespace slam_ros
