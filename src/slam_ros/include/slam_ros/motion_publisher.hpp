// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/models/motion.hpp"

namespace slam_ros {

/// Publishes what an odometry source that looks at the ceiling has found: `visual_odometry/odom`
/// (nav_msgs/Odometry; the pose's covariance grows from the start, the twist's is that of the last
/// interval) and, drawn only while somebody looks, `visual_odometry/image` with the matches.
class VisualMotionPublisher {
 public:
  explicit VisualMotionPublisher(ros::NodeHandle handle);

  void publish(const slam::Motion& motion);
  void show(const slam::ViewDrawer& source, slam::Stamp stamp) const;

 private:
  ros::Publisher odometry_, image_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of the pose in the odometry frame
};

}  // namespace slam_ros
