// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/odometry_nodelet.hpp>

namespace slam_command_odometry {

class CommandOdometryNodelet final : public slam_ros::OdometryNodelet {
 public:
  CommandOdometryNodelet() : OdometryNodelet("command") {}
};

}  // namespace slam_command_odometry

PLUGINLIB_EXPORT_CLASS(slam_command_odometry::CommandOdometryNodelet, nodelet::Nodelet)
