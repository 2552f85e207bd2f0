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

/// What the services do with the estimator, said by who owns it.
struct LocalisationActions {
  /// The robot may be anywhere in the map; an error where there is none.
  std::function<slam::Status()> search;
  std::function<void()> search_anyway;  ///< with the next scan, also where the robot stands still
  /// A grid takes the map's place; empty where the back-end makes none.
  std::function<slam::Status(const slam::MapState&)> set_map;
  std::function<void(const std::string& topic, const slam::Status&)> report;
};

/// Offers the services `global_localization`, `request_nomotion_update` and, of back-ends that make
/// a grid, `set_map`, as amcl has them.
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
