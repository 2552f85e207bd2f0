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

/// The message of a grid. Its cells are row-major as in the grid; its axes are those of the map
/// frame.
nav_msgs::OccupancyGrid toMsg(const slam::OccupancyGrid& grid, slam::Stamp stamp,
                              const std::string& frame);
/// @pre the grid is not rotated
slam::OccupancyGrid fromMsg(const nav_msgs::OccupancyGrid& message);
/// Whether the grid's axes are not those of its frame, or its origin is not a number.
bool isTurned(const nav_msgs::OccupancyGrid& message);

/// Publishes `map` and `map_metadata` (latched) and offers the services `dynamic_map` and
/// `static_map`, like gmapping and map_server. The filter's thread copies the grid at a bounded
/// rate, if it has changed and somebody has subscribed; another thread sends the message.
class GridPublisher {
 public:
  /// @param period of the map at least [s of stamps]
  GridPublisher(ros::NodeHandle handle, const slam::GridMapper& mapper, std::string map_frame,
                double period);

  /// To be called after each step: publishes if it is time.
  void update(slam::Stamp stamp);
  /// Publishes what the period held back, and for new subscribers.
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
