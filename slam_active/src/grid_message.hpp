// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include <cmath>

#include "slam_core/models/occupancy_grid.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_active {

/// Whether the axes of a grid are not those of its frame, or its origin is no number.
inline bool isTurned(const nav_msgs::OccupancyGrid& message) {
  return !(std::abs(slam_ros::fromMsg(message.info.origin).theta()) < 1e-6);
}

/// A grid that is not turned.
inline slam::OccupancyGrid gridOf(const nav_msgs::OccupancyGrid& message) {
  slam::OccupancyGrid grid;
  grid.resolution = message.info.resolution;
  grid.origin = slam_ros::fromMsg(message.info.origin).position();
  grid.width = message.info.width;
  grid.height = message.info.height;
  grid.cells = message.data;
  return grid;
}

}  // namespace slam_active
