// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/SetMap.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Empty.h>

#include <functional>
#include <string>

#include "slam_core/common/status.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam_ros {

/// The functions that the services call; the owner of the estimator provides them.
struct LocalisationActions {
  /// Starts a search of the whole map for the robot; returns an error if there is no map.
  std::function<slam::Status()> search;
  std::function<void()> search_anyway;  ///< with the next scan, even if the robot stands still
  /// Replaces the map by a grid; empty if the back-end makes no grid.
  std::function<slam::Status(const slam::MapState&)> set_map;
  std::function<void(const std::string& topic, const slam::Status&)> report;
};

/// Offers the services `global_localization`, `request_nomotion_update` and, for back-ends that
/// make a grid, `set_map`, like amcl.
class LocalisationServices {
 public:
  LocalisationServices(ros::NodeHandle handle, std::string map_frame, LocalisationActions actions);

 private:
  bool search(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool searchAnyway(std_srvs::Empty::Request&, std_srvs::Empty::Response&);
  bool setMap(nav_msgs::SetMap::Request& request, nav_msgs::SetMap::Response& response);

  std::string map_frame_;
  LocalisationActions actions_;
  ros::ServiceServer search_, search_anyway_, set_map_;
};

}  // namespace slam_ros
