// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/wall_timer.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "slam_core/point_map/point_map.hpp"
#include "slam_ros/background.hpp"
#include "slam_ros/module_publisher.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// A point cloud with the fields x, y, z [m] and intensity: the number of end points of which each
/// point is the mean.
sensor_msgs::PointCloud2 toMsg(const std::vector<slam::point_map::MapPoint>& points,
                               slam::Stamp stamp, const std::string& frame);

/// Publishes `points` (latched) at a bounded rate, if they have changed and somebody has
/// subscribed. Another thread than the one that updates the map makes the message.
class PointsPublisher final : public ModulePublisher {
 public:
  PointsPublisher(const slam::point_map::PointMap& map, const Context& context);

  void update() override;

 private:
  void flush();
  void publish();

  const slam::point_map::PointMap& map_;
  std::string map_frame_;
  ros::Publisher points_;
  RateLimit rate_;
  std::uint64_t published_ = 0;  ///< revision of the map
  std::uint32_t subscribers_ = 0;
  Background background_;
  ros::WallTimer flush_timer_;  ///< what the rate held back, and for those who subscribed since
};

}  // namespace slam_ros
