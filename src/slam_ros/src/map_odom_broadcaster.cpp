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
                                       const OutputsConfig& config,
                                       const slam::JumpLimit::Limits& limits)
    : handle_(handle), map_frame_(std::move(map_frame)), limit_(limits) {
  const auto poll = [this](const ros::WallTimerEvent&) { sendIfDue(fromRos(ros::Time::now())); };
  poll_ = handle.createWallTimer(ros::WallDuration(kPoll), poll);
  configure(config);
}

void MapOdomBroadcaster::configure(const OutputsConfig& config) {
  interval_ = slam::durationFromSeconds(1.0 / config.tf_rate);
  tolerance_ = slam::durationFromSeconds(config.transform_tolerance);
  poll_.setPeriod(ros::WallDuration(std::min(kPoll, 0.5 / config.tf_rate)));
}

void MapOdomBroadcaster::update(const slam::StepReport& report) {
  odometry_frame_ = report.odometry_frame;
  if (report.is_relocated) limit_.restart();
  if (report.has_motion)
    T_map_odom_ = limit_.follow(report.stamp, report.pose.pose, report.odometry_pose);
  else
    updateWithoutMotion(report);
  send(report.stamp);
}

void MapOdomBroadcaster::updateWithoutMotion(const slam::StepReport& report) {
  if (!watch_) watch_.emplace(handle_, frameId(report.odometry_frame), frameId(report.base_frame));
  base_frame_ = watch_->isTaken() || !watch_->hasListened() ? "" : report.base_frame;
  if (!watch_->isTaken())
    T_map_odom_ = report.pose.pose;
  else if (const auto T_odom_base = watch_->at(report.stamp))
    T_map_odom_ = limit_.follow(report.stamp, report.pose.pose, *T_odom_base);
}

void MapOdomBroadcaster::reset() {
  odometry_frame_.clear();
  limit_.restart();
  publisher_.reset();
  base_publisher_.reset();
}

void MapOdomBroadcaster::sendIfDue(slam::Stamp now) {
  const bool has_jumped = due_ && (now > *due_ + interval_ || now < *due_ - interval_);
  if (due_ && !has_jumped && now < *due_) return;
  due_ = (due_ && !has_jumped ? *due_ : now) + interval_;
  send(now);
}

void MapOdomBroadcaster::send(slam::Stamp now) {
  if (odometry_frame_.empty()) return;
  const auto stamp = toRos(now + tolerance_);
  publisher_.publish(stamp, map_frame_, odometry_frame_, T_map_odom_);
  if (base_frame_.empty()) return;
  watch_->noteOwn({fromRos(stamp), slam::Pose2()});
  base_publisher_.publish(stamp, odometry_frame_, base_frame_, slam::Pose2());
}

}  // namespace slam_ros
