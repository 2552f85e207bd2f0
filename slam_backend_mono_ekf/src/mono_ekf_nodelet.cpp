// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_mono_ekf {

class MonoEkfNodelet final : public slam_ros::BackendNodelet {
 public:
  MonoEkfNodelet() : BackendNodelet("mono_ekf") {}
};

}  // namespace slam_backend_mono_ekf

PLUGINLIB_EXPORT_CLASS(slam_backend_mono_ekf::MonoEkfNodelet, nodelet::Nodelet)
