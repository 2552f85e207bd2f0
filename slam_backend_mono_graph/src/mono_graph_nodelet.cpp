// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

namespace slam_backend_mono_graph {

class MonoGraphNodelet final : public slam_ros::BackendNodelet {
 public:
  MonoGraphNodelet() : BackendNodelet("mono_graph") {}
};

}  // namespace slam_backend_mono_graph

PLUGINLIB_EXPORT_CLASS(slam_backend_mono_graph::MonoGraphNodelet, nodelet::Nodelet)
