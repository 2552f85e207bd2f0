// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/odometry_source.hpp"

namespace slam_ros {

/// Publishes the results of an odometry source with a frame of its own: `NAME_odometry/odom`
/// (nav_msgs/Odometry; the pose's covariance grows from the start, the twist's is that of the last
/// interval) and, for a source with a camera, `NAME_odometry/image`, which is drawn only while
/// somebody has subscribed.
class MotionPublisher {
 public:
  /// @param source outlives this
  MotionPublisher(ros::NodeHandle handle, const slam::OdometrySource& source);

  void publish(const slam::Motion& motion);

 private:
  void publishOdometry(const slam::Motion& motion) const;
  void show(slam::Stamp stamp) const;

  const slam::ViewDrawer* drawer_;  ///< null: the source draws nothing
  ros::Publisher odometry_, image_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of the pose in the odometry frame
};

}  // namespace slam_ros
