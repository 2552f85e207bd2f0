// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <mutex>
#include <optional>
#include <string>

#include "slam_ros/after_load.hpp"
#include "slam_ros/camera_input.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/door.hpp"
#include "slam_ros/latency_window.hpp"

namespace slam_ros {

/// Subscribes a camera once its nodelet is loaded: raw and compressed images, camera_info and
/// /tf_static. All callbacks come from the node handle's queue. Its owner calls stop() before what
/// the sinks need goes away.
class CameraSubscriber {
 public:
  struct Options {
    std::string topic;  ///< of the raw images
    std::string transport =
        "auto";  ///< "raw", "compressed"; "auto": the kind that comes first stays
    std::string base_frame;
  };

  /// @throw ros::InvalidNameException
  /// @param pass of all callbacks
  CameraSubscriber(ros::NodeHandle handle, const Options& options, CameraInput::Sinks sinks,
                   Pass pass);

  const std::string& topic() const { return topics_.raw; }
  /// "waiting for ...", or empty when all have come that a component may need.
  std::string waiting() const;
  /// When the last image came, by the wall.
  LatencyWindow::Clock::time_point arrival() const { return arrival_; }
  /// From here on no callback runs.
  void stop();

 private:
  void subscribe(ros::NodeHandle handle, const std::string& transport);
  template <class Message>
  void take(const Message& message);
  void onImage(const sensor_msgs::Image& message);
  void onCompressedImage(const sensor_msgs::CompressedImage& message);

  CameraTopics topics_;
  Pass pass_;
  CameraInput input_;
  LatencyWindow::Clock::time_point arrival_;
  std::mutex kind_;  ///< held while it is told which of raw_ and compressed_ there are
  ros::Subscriber raw_, compressed_, info_, transforms_;
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros
