// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/fast_slam.hpp"
#include "slam_core/particle_filter/mixture.hpp"

namespace slam::particle_filter {

PoseEstimate FastSlam::pose() const {
  const auto& estimate = told_.estimate;
  return config_.pose == "best" ? about(particles_->best().pose, estimate) : estimate;
}

LandmarkMap FastSlam::landmarks() const {
  LandmarkMap map;
  map.reserve(index_.size());
  const auto& best = particles_->best().map;
  for (const auto slot : index_.slotsById()) {
    auto landmark = config_.map == "best"
                        ? mixtureAbout(best[slot].mean(), *particles_, slot, index_.id(slot))
                        : mixtureOf(*particles_, slot, index_.id(slot));
    landmark.covariance = bound_.told(landmark.covariance, slot);
    map.push_back(landmark);
  }
  return map;
}

MapState FastSlam::state() const { return {pose(), landmarks(), {}}; }

std::vector<StampedPose> FastSlam::path() const {
  const auto& best = particles_->best();
  return best.path.poses(best.pose);
}

std::vector<Pose2> FastSlam::particles() const {
  std::vector<Pose2> poses;
  poses.reserve(particles_->size());
  for (std::size_t i = 0; i < particles_->size(); ++i) poses.push_back((*particles_)[i].pose);
  return poses;
}

}  // namespace slam::particle_filter
