// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// `particlecloud` of back-ends with particles, at a bounded rate; nothing is advertised for
/// others.
class ParticlePublisher {
 public:
  ParticlePublisher(ros::NodeHandle handle, const slam::PoseSampler& sampler, std::string map_frame,
                    double rate);

  /// A step was taken: publishes when it is time and somebody listens.
  void update(slam::Stamp stamp);
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  const slam::PoseSampler& sampler_;
  std::string map_frame_;
  ros::Publisher cloud_;
  RateLimit rate_;
};

}  // namespace slam_ros
