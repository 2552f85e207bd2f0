// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/map_odom_broadcaster.hpp"

#include <algorithm>
#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr double kPoll = 0.01;  // [s] of the wall

}  // namespace

MapOdomBroadcaster::MapOdomBroadcaster(ros::NodeHandle handle, std::string map_frame,
                                       const OutputsConfig& config)
    : map_frame_(std::move(map_frame)),
      interval_(slam::durationFromSeconds(1.0 / config.tf_rate)),
      tolerance_(slam::durationFromSeconds(config.transform_tolerance)) {
  const auto poll = [this](const ros::WallTimerEvent&) { sendIfDue(fromRos(ros::Time::now())); };
  poll_ = handle.createWallTimer(ros::WallDuration(std::min(kPoll, 0.5 / config.tf_rate)), poll);
}

void MapOdomBroadcaster::update(const slam::StepReport& report) {
  T_map_odom_ = report.pose.pose * report.odometry_pose.inverse();
  odometry_frame_ = report.odometry_frame;
  send(report.stamp);
}

void MapOdomBroadcaster::reset() {
  odometry_frame_.clear();
  publisher_.reset();
}

void MapOdomBroadcaster::sendIfDue(slam::Stamp now) {
  const bool has_jumped = due_ && (now > *due_ + interval_ || now < *due_ - interval_);
  if (due_ && !has_jumped && now < *due_) return;
  due_ = (due_ && !has_jumped ? *due_ : now) + interval_;
  send(now);
}

void MapOdomBroadcaster::send(slam::Stamp now) {
  if (!odometry_frame_.empty())
    publisher_.publish(toRos(now + tolerance_), map_frame_, odometry_frame_, T_map_odom_);
}

}  // namespace slam_ros
