// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/odometry_nodelet.hpp>

namespace slam_laser_odometry {

class LaserOdometryNodelet final : public slam_ros::OdometryNodelet {
 public:
  LaserOdometryNodelet() : OdometryNodelet("laser") {}
};

}  // namespace slam_laser_odometry

PLUGINLIB_EXPORT_CLASS(slam_laser_odometry::LaserOdometryNodelet, nodelet::Nodelet)
