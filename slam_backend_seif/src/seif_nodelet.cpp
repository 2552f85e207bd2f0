// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_seif {

class SeifNodelet final : public slam_ros::BackendNodelet {
 public:
  SeifNodelet() : BackendNodelet("seif") {}
};

}  // namespace slam_backend_seif

PLUGINLIB_EXPORT_CLASS(slam_backend_seif::SeifNodelet, nodelet::Nodelet)
