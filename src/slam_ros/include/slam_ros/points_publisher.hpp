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

/// Of fields x, y, z [m] and intensity, how many end points each point is the mean of.
sensor_msgs::PointCloud2 toMsg(const std::vector<slam::point_map::MapPoint>& points,
                               slam::Stamp stamp, const std::string& frame);

/// `points` (latched), while somebody looks and when they have changed, at a bounded rate. The
/// message is made beside the thread that updates the map.
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
