// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_scan_backend_toy {

class ScanNodelet final : public slam_ros::BackendNodelet {
 public:
  ScanNodelet() : BackendNodelet("scan_toy") {}
};

}  // namespace slam_scan_backend_toy

PLUGINLIB_EXPORT_CLASS(slam_scan_backend_toy::ScanNodelet, nodelet::Nodelet)
