// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/motion_publisher.hpp"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Image.h>

#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {
namespace {

/// Of a plane motion's coordinates into x, y and yaw of a 6x6 covariance; the others are known to
/// be 0.
void setCovariance(boost::array<double, 36>& covariance, const Eigen::Matrix3d& C) {
  constexpr std::size_t kIndex[] = {0, 1, 5};
  for (std::size_t i = 0; i < 6; ++i) covariance[7 * i] = 1e-9;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      covariance[6 * kIndex[row] + kIndex[column]] = C(row, column);
}

}  // namespace

MotionPublisher::MotionPublisher(ros::NodeHandle handle, const slam::OdometrySource& source)
    : drawer_(dynamic_cast<const slam::ViewDrawer*>(&source)) {
  const auto place = source.name() + "_odometry";
  odometry_ = handle.advertise<nav_msgs::Odometry>(place + "/odom", kQueue);
  if (drawer_ != nullptr) image_ = handle.advertise<sensor_msgs::Image>(place + "/image", 2);
}

void MotionPublisher::publish(const slam::Motion& motion) {
  Eigen::Matrix3d J_pose, J_step;
  motion.odometry_start.compose(motion.increment, &J_pose, &J_step);
  if (motion.sequence == 0) covariance_.setZero();  // it started over
  covariance_ =
      J_pose * covariance_ * J_pose.transpose() + J_step * motion.covariance * J_step.transpose();
  if (odometry_.getNumSubscribers() > 0) publishOdometry(motion);
  if (drawer_ != nullptr && image_.getNumSubscribers() > 0) show(motion.end);
}

void MotionPublisher::publishOdometry(const slam::Motion& motion) const {
  const double dt = slam::seconds(motion.end - motion.start);
  const Eigen::Vector3d twist = motion.increment.log() / dt;
  auto message = boost::make_shared<nav_msgs::Odometry>();
  message->header.stamp = toRos(motion.end);
  message->header.frame_id = frameId(motion.odometry_frame);
  message->child_frame_id = frameId(motion.base_frame);
  const auto transform = toTransformMsg(motion.odometry_end);
  message->pose.pose.position.x = transform.translation.x;
  message->pose.pose.position.y = transform.translation.y;
  message->pose.pose.orientation = transform.rotation;
  setCovariance(message->pose.covariance, covariance_);
  message->twist.twist.linear.x = twist.x();
  message->twist.twist.linear.y = twist.y();
  message->twist.twist.angular.z = twist.z();
  setCovariance(message->twist.covariance, motion.covariance / (dt * dt));
  odometry_.publish(message);
}

void MotionPublisher::show(slam::Stamp stamp) const {
  const auto drawing = drawer_->drawing();
  if (drawing.empty()) return;
  std_msgs::Header header;
  header.stamp = toRos(stamp);
  image_.publish(boost::make_shared<sensor_msgs::Image>(toMsg(drawing, header)));
}

}  // namespace slam_ros
