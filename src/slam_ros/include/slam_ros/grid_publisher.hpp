// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <string>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_ros/background.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// The row-major cells as they are; the axes are those of the map frame.
nav_msgs::OccupancyGrid toMsg(const slam::OccupancyGrid& grid, slam::Stamp stamp,
                              const std::string& frame);
/// @pre the grid is not turned
slam::OccupancyGrid fromMsg(const nav_msgs::OccupancyGrid& message);
/// Whether the grid's axes are not those of its frame, or its origin is no number.
bool isTurned(const nav_msgs::OccupancyGrid& message);

/// `map` and `map_metadata` (latched) and the services `dynamic_map` and `static_map`, as gmapping
/// and map_server have them. The filter's thread copies the grid, while somebody looks and when it
/// has changed, at a bounded rate; the message is sent beside it.
class GridPublisher {
 public:
  /// @param period of the map at least [s of stamps]
  GridPublisher(ros::NodeHandle handle, const slam::GridMapper& mapper, std::string map_frame,
                double period);

  /// A step was taken: publishes when it is time.
  void update(slam::Stamp stamp);
  /// What the period held back, and for those who have subscribed since.
  void flush();
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  void publish();
  bool answer(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response);

  const slam::GridMapper& mapper_;
  std::string map_frame_;
  ros::Publisher map_, metadata_;
  ros::ServiceServer dynamic_, static_;
  RateLimit rate_;
  slam::Stamp stamp_;
  std::uint64_t published_ = 0;  ///< revision of the grid
  std::uint32_t subscribers_ = 0;
  Background background_;
};

}  // namespace slam_ros
