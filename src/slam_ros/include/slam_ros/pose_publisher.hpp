// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/product/estimator.hpp"
#include "slam_ros/rate_limit.hpp"
#include "slam_ros/thinned_path.hpp"

namespace slam_ros {

/// Publishes `pose` at every step and `path`, thinned if it is long, at a bounded rate.
class PosePublisher {
 public:
  PosePublisher(ros::NodeHandle handle, std::string map_frame, double path_rate);

  void publish(const slam::StepReport& report);
  /// Publishes what the rate held back, and for new subscribers.
  void flush();
  /// Starts the path over.
  void reset();
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  std::string map_frame_;
  ros::Publisher pose_, path_publisher_;
  RateLimit rate_;
  ThinnedPath path_;
  bool path_is_new_ = true;
  std::uint32_t subscribers_ = 0;
};

}  // namespace slam_ros
