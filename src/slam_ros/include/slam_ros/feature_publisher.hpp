// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "slam_core/contract/feature_mapper.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// A point cloud with the fields x, y, z [m].
sensor_msgs::PointCloud2 toMsg(const std::vector<slam::MappedFeature>& features, slam::Stamp stamp,
                               const std::string& frame);

/// Publishes `features`, for back-ends that map features of images, at a bounded rate.
class FeaturePublisher {
 public:
  FeaturePublisher(ros::NodeHandle handle, const slam::FeatureMapper& mapper, std::string map_frame,
                   double rate);

  /// To be called after each step: publishes if it is time and somebody has subscribed.
  void update(slam::Stamp stamp);
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  const slam::FeatureMapper& mapper_;
  std::string map_frame_;
  ros::Publisher features_;
  RateLimit rate_;
};

}  // namespace slam_ros
