// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_grid {

class GridNodelet final : public slam_ros::BackendNodelet {
 public:
  GridNodelet() : BackendNodelet("grid") {}
};

}  // namespace slam_backend_grid

PLUGINLIB_EXPORT_CLASS(slam_backend_grid::GridNodelet, nodelet::Nodelet)
