// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/event_publisher.hpp"

#include <slam_msgs/Event.h>

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr std::uint32_t kEventQueue = 100;

}  // namespace

EventPublisher::EventPublisher(ros::NodeHandle handle, std::string map_frame)
    : map_frame_(std::move(map_frame)),
      publisher_(handle.advertise<slam_msgs::Event>("events", kEventQueue)) {}

void EventPublisher::publish(const slam::StepReport& report) const {
  if (publisher_.getNumSubscribers() == 0) return;
  for (const auto& event : report.events) {
    slam_msgs::Event message;
    message.header.stamp = toRos(event.stamp);
    message.header.frame_id = map_frame_;
    message.kind = slam::nameOf(event.kind, slam::namesOfEvents());
    message.distance = event.distance;
    message.turn = event.turn;
    message.reason = event.reason;
    publisher_.publish(message);
  }
}

}  // namespace slam_ros
