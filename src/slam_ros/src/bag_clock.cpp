// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_clock.hpp"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

const ros::WallDuration kTick(0.01);

}  // namespace

BagClock::BagClock(ros::NodeHandle handle, double rate, bool publish)
    : rate_(rate), publishes_(publish) {
  if (publishes_) publisher_ = handle.advertise<rosgraph_msgs::Clock>("/clock", 10);
}

void BagClock::waitUntil(const ros::Time& time, const std::atomic<bool>& stop) {
  if (first_.isZero()) {
    first_ = time;
    begin_ = ros::WallTime::now();
  }
  while (rate_ > 0 && !stop) {
    const double passed = (ros::WallTime::now() - begin_).toSec();
    // as stamps: ROS's durations end at 68 years, which two times of a bag may lie apart
    const double wait = slam::seconds(fromRos(time) - fromRos(first_)) / rate_ - passed;
    if (wait <= 0) break;
    publish(toRos(fromRos(first_) + slam::durationFromSeconds(passed * rate_)));
    std::min(kTick, ros::WallDuration(wait)).sleep();
  }
  publish(time);
}

void BagClock::publish(const ros::Time& time) {
  if (!publishes_ || time <= published_) return;
  published_ = time;
  rosgraph_msgs::Clock message;
  message.clock = time;
  publisher_.publish(message);
}

}  // namespace slam_ros
