// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/particle_publisher.hpp"

#include <geometry_msgs/PoseArray.h>

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

ParticlePublisher::ParticlePublisher(ros::NodeHandle handle, const slam::PoseSampler& sampler,
                                     std::string map_frame, double rate)
    : sampler_(sampler), map_frame_(std::move(map_frame)), rate_(rate) {
  if (!sampler.particles().empty())
    cloud_ = handle.advertise<geometry_msgs::PoseArray>("particlecloud", 1);
}

void ParticlePublisher::update(slam::Stamp stamp) {
  if (!cloud_ || cloud_.getNumSubscribers() == 0 || !rate_.isDue(stamp)) return;
  geometry_msgs::PoseArray cloud;
  cloud.header.stamp = toRos(stamp);
  cloud.header.frame_id = map_frame_;
  for (const auto& pose : sampler_.particles()) cloud.poses.push_back(toSpatialMsg(pose));
  cloud_.publish(cloud);
}

}  // namespace slam_ros
