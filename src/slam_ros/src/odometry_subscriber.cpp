// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/odometry_subscriber.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr std::uint32_t kOdometryQueue = 1000;
constexpr char kTransforms[] = "/tf";

}  // namespace

OdometrySubscriber::OdometrySubscriber(const ros::NodeHandle& handle, Options options, Take take,
                                       Pass pass)
    : handle_(handle),
      options_(std::move(options)),
      take_(std::move(take)),
      pass_(std::move(pass)),
      edge_(frameId(options_.odom_frame), frameId(options_.base_frame)),
      source_(options_.topic) {
  handle_.resolveName(options_.topic);  // throws now what subscribing would throw later
}

void OdometrySubscriber::subscribe() {
  odom_ = subscribeThrough<nav_msgs::Odometry>(pass_, handle_, options_.topic, kOdometryQueue,
                                               [this](const auto& message) { onOdom(message); });
  if (options_.also_tf)
    tf_ = handle_.subscribe(kTransforms, kOdometryQueue, &OdometrySubscriber::onTransforms, this);
}

void OdometrySubscriber::shutdown() {
  odom_.shutdown();
  tf_.shutdown();
}

std::string OdometrySubscriber::waiting() const {
  if (got_message_) return "";
  return "waiting for odometry on " + options_.topic +
         (options_.also_tf ? " or as the transform " + frameId(options_.odom_frame) + " -> " +
                                 frameId(options_.base_frame)
                           : "");
}

void OdometrySubscriber::onOdom(const nav_msgs::Odometry& message) {
  tf_.shutdown();
  got_message_ = true;
  source_ = options_.topic;
  take_(message);
}

void OdometrySubscriber::onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
  if (options_.but_own && event.getPublisherName() == ros::this_node::getName()) return;
  pass_(kTransforms, [&] { take(*event.getMessage()); });
}

void OdometrySubscriber::take(const tf2_msgs::TFMessage& message) {
  if (odom_.getNumPublishers() > 0 || !edge_.isIn(message)) return;
  if (!got_message_)
    ROS_INFO_STREAM("nobody publishes " << odom_.getTopic()
                                        << ": odometry is taken from the "
                                           "transform "
                                        << frameId(options_.odom_frame) << " -> "
                                        << frameId(options_.base_frame));
  got_message_ = true;
  source_ = kTransforms;
  edge_.take(message, take_);
}

}  // namespace slam_ros
