// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/motion_outputs.hpp"

#include <slam_msgs/Motion.h>

#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {
MotionOutputs::MotionOutputs(ros::NodeHandle handle, const OdometryNodeletConfig& config,
                             const slam::FramesConfig& frames, const slam::OdometrySource& source,
                             std::string motion_topic, Warn warn)
    : handle_(handle),
      config_(config),
      frames_(frames),
      source_(source),
      motion_topic_(std::move(motion_topic)),
      warn_(std::move(warn)),
      shown_(handle, source) {
  if (config_.publish_tf && config_.publish_motion)
    watch_.emplace(handle, frameId(frames_.odom), frameId(frames_.base));
}

void MotionOutputs::advertise() {
  if (config_.publish_motion) motion_ = handle_.advertise<slam_msgs::Motion>(motion_topic_, kQueue);
}

void MotionOutputs::publish(slam::Motion motion) {
  const bool is_taken = isEdgeTaken();
  motion.odometry_frame = is_taken || !config_.publish_motion ? ownFrame() : "";
  frames_.complete(motion.odometry_frame, motion.base_frame);
  if (motion_) motion_.publish(boost::make_shared<slam_msgs::Motion>(toMsg(motion)));
  if (watch_ && !is_taken) {
    watch_->noteOwn({motion.end, motion.odometry_end});
    transform_.publish(toRos(motion.end), motion.odometry_frame, motion.base_frame,
                       motion.odometry_end);
  }
  shown_.publish(motion);
}

std::string MotionOutputs::ownFrame() const { return source_.name() + "_odom"; }

bool MotionOutputs::isEdgeTaken() {
  const bool is_taken = watch_ && watch_->isTaken();
  if (is_taken && !std::exchange(warned_of_edge_, true))
    warn_("the transform " + frames_.odom + " -> " + frames_.base + " is published by " +
          watch_->publisher() + " as well; " + source_.name() +
          " odometry leaves it out and calls its frame " + ownFrame());
  return is_taken;
}

}  // namespace slam_ros
