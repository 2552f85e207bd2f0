// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_pf {

class PfNodelet final : public slam_ros::BackendNodelet {
 public:
  PfNodelet() : BackendNodelet("pf") {}
};

}  // namespace slam_backend_pf

PLUGINLIB_EXPORT_CLASS(slam_backend_pf::PfNodelet, nodelet::Nodelet)
