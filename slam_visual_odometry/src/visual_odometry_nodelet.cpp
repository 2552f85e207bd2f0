// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/odometry_nodelet.hpp>

namespace slam_visual_odometry {

class VisualOdometryNodelet final : public slam_ros::OdometryNodelet {
 public:
  VisualOdometryNodelet() : OdometryNodelet("visual") {}
};

}  // namespace slam_visual_odometry

PLUGINLIB_EXPORT_CLASS(slam_visual_odometry::VisualOdometryNodelet, nodelet::Nodelet)
