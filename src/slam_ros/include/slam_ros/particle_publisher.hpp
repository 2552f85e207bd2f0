// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// Publishes `particlecloud` at a bounded rate. Nothing is advertised for back-ends without
/// particles.
class ParticlePublisher {
 public:
  ParticlePublisher(ros::NodeHandle handle, const slam::PoseSampler& sampler, std::string map_frame,
                    double rate);

  /// To be called after each step: publishes if it is time and somebody has subscribed.
  void update(slam::Stamp stamp);
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  const slam::PoseSampler& sampler_;
  std::string map_frame_;
  ros::Publisher cloud_;
  RateLimit rate_;
};

}  // namespace slam_ros
