// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <std_msgs/Header.h>

#include "slam_core/active_path/explorer.hpp"

namespace slam_active {

/// Publishes decisions: `move_base_simple/goal` where the goal is another, `active_path/way` each
/// time, `active_path/markers` while somebody looks, and `explored` where that has changed. All are
/// latched.
class DecisionPublisher {
 public:
  explicit DecisionPublisher(ros::NodeHandle handle);

  /// @param resolution of the map [m]
  /// @param header stamp of the pose, and the map's frame
  void publish(const slam::active_path::Decision& decision, double resolution,
               const std_msgs::Header& header);
  /// An empty way: who follows it stops.
  void stop(const std_msgs::Header& header) { publishWay({}, header); }

 private:
  void publishGoal(const slam::active_path::Goal& goal, const std_msgs::Header& header);
  void publishWay(const slam::active_path::Decision& decision, const std_msgs::Header& header);
  void publishExplored(bool is_explored);

  ros::Publisher goal_, way_, markers_, explored_;
  bool is_explored_ = false;  ///< as published last
};

}  // namespace slam_active
