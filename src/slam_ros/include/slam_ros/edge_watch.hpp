// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "slam_core/contract/stamped_pose.hpp"

namespace slam_ros {

/// Detects whether another node publishes one edge of the tree of transforms, since two publishers
/// of an edge would contradict each other. It listens in a thread of its own: the transforms of a
/// whole robot are many, and images should not wait for them.
class EdgeWatch {
 public:
  EdgeWatch(ros::NodeHandle handle, std::string parent, std::string child);

  /// To be called by the owner of this watch before it publishes the edge. A driver in the same
  /// process has the same node name, so that only the published values tell them apart.
  void noteOwn(const slam::StampedPose& edge);
  /// Whether it has listened for long enough to have heard a driver.
  bool hasListened() const;
  bool isTaken() const { return is_taken_; }
  /// The node that publishes the edge, if isTaken().
  const std::string& publisher() const { return publisher_; }
  /// The edge as the other node publishes it at a time, or the latest one before if that has not
  /// come yet; nothing if the time is older than all that is kept.
  std::optional<slam::Pose2> at(slam::Stamp stamp) const;

 private:
  void onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);
  bool isOwn(const slam::StampedPose& edge) const;
  void keep(const slam::StampedPose& edge);
  std::deque<slam::StampedPose>::const_iterator behind(slam::Stamp stamp) const;

  std::string parent_, child_, publisher_;
  std::atomic<bool> is_taken_{false};  ///< written last: then publisher_ does not change
  mutable std::mutex mutex_;
  std::deque<slam::StampedPose> edges_;  ///< the latest ones, by stamp
  std::deque<slam::StampedPose> own_;    ///< the owner's latest ones
  ros::WallTime began_ = ros::WallTime::now();
  ros::CallbackQueue queue_;
  ros::Subscriber transforms_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace slam_ros
