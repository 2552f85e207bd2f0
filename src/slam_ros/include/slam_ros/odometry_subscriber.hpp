// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>

#include "slam_ros/door.hpp"
#include "slam_ros/odometry_edge.hpp"

namespace slam_ros {

/// A robot's odometry: the topic or, as long as nobody publishes that, the transform
/// odom -> base of /tf, which is all that some robots tell. Once the topic has a message, /tf is
/// left alone. Not for odometry whose transform we publish ourselves: then only the topic counts,
/// or what others publish.
class OdometrySubscriber {
 public:
  struct Options {
    std::string topic;
    std::string odom_frame, base_frame;
    bool also_tf = true;
    bool but_own = false;  ///< not the transforms that this node publishes
  };
  using Take = std::function<void(const nav_msgs::Odometry&)>;

  /// The names are checked here; nothing is subscribed to. @throw ros::InvalidNameException
  /// @param pass of all callbacks
  OdometrySubscriber(const ros::NodeHandle& handle, Options options, Take take, Pass pass);

  /// To be called once the nodelet is loaded (AfterLoad).
  void subscribe();
  void shutdown();

  /// Where the last message came from, or the topic that is waited for.
  const std::string& source() const { return source_; }
  /// What is waited for; empty once a message came.
  std::string waiting() const;

 private:
  void onOdom(const nav_msgs::Odometry& message);
  void onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event);
  void take(const tf2_msgs::TFMessage& message);

  ros::NodeHandle handle_;
  Options options_;
  Take take_;
  Pass pass_;
  OdometryEdge edge_;
  std::string source_;
  bool got_message_ = false;
  ros::Subscriber odom_, tf_;
};

}  // namespace slam_ros
