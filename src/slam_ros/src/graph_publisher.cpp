// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/graph_publisher.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/graph_markers.hpp"

namespace slam_ros {

GraphPublisher::GraphPublisher(ros::NodeHandle handle, const slam::GraphReporter& reporter,
                               std::string map_frame, double period)
    : reporter_(reporter),
      map_frame_(std::move(map_frame)),
      markers_(handle.advertise<visualization_msgs::MarkerArray>("graph_markers", 1)),
      rate_(1.0 / period) {}

void GraphPublisher::update(slam::Stamp stamp) {
  stamp_ = stamp;
  is_new_ = true;
  if (markers_.getNumSubscribers() > 0 && rate_.isDue(stamp)) publish();
}

void GraphPublisher::flush() {
  const bool stands_still = std::exchange(last_flush_, stamp_) == stamp_;
  const auto subscribers = markers_.getNumSubscribers();
  const bool is_held_back = is_new_ && stands_still && subscribers > 0;
  if (is_held_back || subscribers > subscribers_) publish();
  subscribers_ = subscribers;
}

void GraphPublisher::publish() {
  is_new_ = false;
  std_msgs::Header header;
  header.stamp = toRos(stamp_);
  header.frame_id = map_frame_;
  markers_.publish(toMarkers(reporter_.graph(), header));
}

}  // namespace slam_ros
