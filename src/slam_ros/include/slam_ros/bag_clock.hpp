// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>

namespace slam_ros {

/// Plays the time of a bag: waits for each message's time at a rate and publishes /clock.
class BagClock {
 public:
  /// @param rate times the recorded speed; 0: no waiting
  BagClock(ros::NodeHandle handle, double rate, bool publish);

  /// Returns when `time` has come, or when `stop` is set.
  void waitUntil(const ros::Time& time, const std::atomic<bool>& stop);

 private:
  void publish(const ros::Time& time);

  double rate_;
  bool publishes_;
  ros::Publisher publisher_;
  ros::Time first_, published_;
  ros::WallTime begin_;
};

}  // namespace slam_ros
