// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <slam_msgs/LoadMap.h>
#include <slam_msgs/RemoveLandmark.h>
#include <slam_msgs/SaveMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>

#include "slam_core/common/status.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/product/map_files.hpp"
#include "slam_ros/map_folder.hpp"

namespace slam_ros {

/// The functions that the services call; the owner of the estimator provides them.
struct BackendActions {
  std::function<void()> reset;
  std::function<void(bool)> pause;
  std::function<slam::LandmarkFile()> map;
  std::function<slam::Status(const slam::LandmarkFile&)> load;
  std::function<slam::Status(slam::LandmarkId)> remove;
  // these are empty if the back-end keeps no sessions
  std::function<slam::SavedSession()> session;
  std::function<slam::Status(const slam::SavedSession&)> take_up, merge;
};

/// Offers the services `reset`, `pause`, `save_map`, `load_map` and `remove_landmark`, and for a
/// back-end that keeps sessions `save_session`, `load_session` and `merge_session`.
class BackendServices {
 public:
  /// @param has_grid whether the back-end's map has a grid
  BackendServices(ros::NodeHandle handle, std::string map_frame, bool has_grid, MapFolder folder,
                  BackendActions actions);

 private:
  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool save(slam_msgs::SaveMap::Request& request, slam_msgs::SaveMap::Response& response);
  bool load(slam_msgs::LoadMap::Request& request, slam_msgs::LoadMap::Response& response);
  bool remove(slam_msgs::RemoveLandmark::Request& request,
              slam_msgs::RemoveLandmark::Response& response);

  bool saveSession(slam_msgs::SaveMap::Request& request, slam_msgs::SaveMap::Response& response);
  bool loadSession(slam_msgs::LoadMap::Request& request, slam_msgs::LoadMap::Response& response);
  bool mergeSession(slam_msgs::LoadMap::Request& request, slam_msgs::LoadMap::Response& response);

  std::string map_frame_;
  bool has_grid_;
  MapFolder folder_;
  BackendActions actions_;
  ros::ServiceServer reset_, pause_, save_, load_, remove_;
  ros::ServiceServer save_session_, load_session_, merge_session_;
};

}  // namespace slam_ros
