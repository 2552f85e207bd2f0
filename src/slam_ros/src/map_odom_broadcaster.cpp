// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/map_odom_broadcaster.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

MapOdomBroadcaster::MapOdomBroadcaster(ros::NodeHandle handle, std::string map_frame,
                                       const OutputsConfig& config)
    : map_frame_(std::move(map_frame)), tolerance_(config.transform_tolerance) {
  timer_ = handle.createTimer(ros::Duration(1.0 / config.tf_rate),
                              [this](const ros::TimerEvent&) { send(ros::Time::now()); });
}

void MapOdomBroadcaster::update(const slam::StepReport& report) {
  T_map_odom_ = report.pose.pose * report.odometry_pose.inverse();
  odometry_frame_ = report.odometry_frame;
  send(toRos(report.stamp));
}

void MapOdomBroadcaster::reset() {
  odometry_frame_.clear();
  publisher_.reset();
}

void MapOdomBroadcaster::send(const ros::Time& now) {
  if (!odometry_frame_.empty())
    publisher_.publish(now + tolerance_, map_frame_, odometry_frame_, T_map_odom_);
}

}  // namespace slam_ros
