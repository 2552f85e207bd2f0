// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_ros/markers.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// Publishes `landmarks` and `landmark_markers` at a bounded rate.
class LandmarkPublisher {
 public:
  LandmarkPublisher(ros::NodeHandle handle, const slam::LandmarkMapper& mapper,
                    std::string map_frame, double rate);

  /// To be called after each step: publishes if it is time.
  void update(slam::Stamp stamp);
  /// To be called when the map has changed without a step.
  void refresh() { is_new_ = true; }
  /// Publishes what the rate held back, and for new subscribers.
  void flush();
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  void publish();

  const slam::LandmarkMapper& mapper_;
  std::string map_frame_;
  ros::Publisher landmarks_, marker_publisher_;
  RateLimit rate_;
  slam::Stamp stamp_;
  LandmarkMarkers markers_;
  bool is_new_ = false;
  std::uint32_t subscribers_ = 0;
};

}  // namespace slam_ros
