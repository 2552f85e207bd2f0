// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/cell_messages.hpp>
#include <slam_ros/stage_nodelet.hpp>

namespace slam_backend_rat {

class LocalViewNodelet final
    : public slam_ros::StageNodelet<slam_msgs::ViewCell, slam::rat::ViewCell, slam_ros::toMsg> {
 public:
  LocalViewNodelet() : StageNodelet("local_view", "local_view") {}
};

class PoseCellsNodelet final
    : public slam_ros::StageNodelet<slam_msgs::PoseCellState, slam::rat::PoseCellState,
                                    slam_ros::toMsg> {
 public:
  PoseCellsNodelet() : StageNodelet("pose_cells", "pose_cells") {}
};

}  // namespace slam_backend_rat

PLUGINLIB_EXPORT_CLASS(slam_backend_rat::LocalViewNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(slam_backend_rat::PoseCellsNodelet, nodelet::Nodelet)
