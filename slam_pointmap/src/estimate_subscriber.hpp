// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <slam_msgs/Motion.h>
#include <slam_msgs/Progress.h>

#include <cstdint>
#include <functional>
#include <string>

#include "slam_core/models/motion.hpp"
#include "slam_core/point_map/point_map.hpp"

namespace slam_pointmap {

/// Subscribes what a back-end estimates with and what comes of it: `motion`, `pose` and `progress`.
/// The sinks must stay until this goes away.
class EstimateSubscriber {
 public:
  struct Sinks {
    std::function<void(const slam::Motion&)> motion;
    std::function<void(const slam::point_map::FilterPose&)> pose;
    /// The back-end was reset or has loaded a map: its poses are those of another map.
    std::function<void()> reset;
  };

  EstimateSubscriber(ros::NodeHandle handle, const std::string& motion_topic, Sinks sinks);

 private:
  void onMotion(const slam_msgs::Motion& message);
  void onPose(const geometry_msgs::PoseWithCovarianceStamped& message);
  void onProgress(const slam_msgs::Progress& message);

  Sinks sinks_;
  std::uint32_t resets_ = 0;
  ros::Subscriber motion_, pose_, progress_;
};

}  // namespace slam_pointmap
