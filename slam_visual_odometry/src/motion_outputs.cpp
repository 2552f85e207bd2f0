// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "motion_outputs.hpp"

#include <slam_msgs/Motion.h>

#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_visual_odometry {
namespace {

constexpr const char* kOwnFrame = "visual_odom";  // where another node publishes odom -> base

}  // namespace

MotionOutputs::MotionOutputs(ros::NodeHandle handle, const NodeletConfig& config,
                             const slam::FramesConfig& frames, const std::string& motion_topic,
                             Warn warn)
    : config_(config), frames_(frames), warn_(std::move(warn)), shown_(handle) {
  if (config_.publish_motion)
    motion_ = handle.advertise<slam_msgs::Motion>(motion_topic, slam_ros::kQueue);
  if (config_.publish_tf)
    watch_.emplace(handle, slam_ros::frameId(frames_.odom), slam_ros::frameId(frames_.base));
}

void MotionOutputs::publish(slam::Motion motion, const slam::OdometrySource* source) {
  const bool is_taken = isEdgeTaken();
  motion.odometry_frame = is_taken || !config_.publish_motion ? kOwnFrame : "";
  frames_.complete(motion.odometry_frame, motion.base_frame);
  if (config_.publish_motion)
    motion_.publish(boost::make_shared<slam_msgs::Motion>(slam_ros::toMsg(motion)));
  if (watch_ && !is_taken && config_.publish_motion)
    transform_.publish(slam_ros::toRos(motion.end), motion.odometry_frame, motion.base_frame,
                       motion.odometry_end);
  shown_.publish(motion);
  if (const auto* drawer = dynamic_cast<const slam::ViewDrawer*>(source))
    shown_.show(*drawer, motion.end);
}

bool MotionOutputs::isEdgeTaken() {
  const bool is_taken = watch_ && watch_->isTaken();
  if (is_taken && !std::exchange(warned_of_edge_, true))
    warn_("the transform " + frames_.odom + " -> " + frames_.base + " is published by " +
          watch_->publisher() + " as well; visual odometry leaves it out and calls its frame " +
          kOwnFrame);
  return is_taken;
}

}  // namespace slam_visual_odometry
