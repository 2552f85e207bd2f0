// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_beacon_toy {

class BeaconNodelet final : public slam_ros::BackendNodelet {
 public:
  BeaconNodelet() : BackendNodelet("beacon_toy") {}
};

}  // namespace slam_beacon_toy

PLUGINLIB_EXPORT_CLASS(slam_beacon_toy::BeaconNodelet, nodelet::Nodelet)
