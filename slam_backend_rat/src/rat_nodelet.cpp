// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_rat {

class RatNodelet final : public slam_ros::BackendNodelet {
 public:
  RatNodelet() : BackendNodelet("rat") {}
};

}  // namespace slam_backend_rat

PLUGINLIB_EXPORT_CLASS(slam_backend_rat::RatNodelet, nodelet::Nodelet)
