// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/fast_slam.hpp"
#include "slam_core/particle_filter/mixture.hpp"

namespace slam::particle_filter {

PoseEstimate FastSlam::pose() const {
  return config_.pose == "best" ? about(particles_->best().pose, estimate_) : estimate_;
}

LandmarkMap FastSlam::landmarks() const {
  LandmarkMap map;
  map.reserve(index_.size());
  const auto& best = particles_->best().map;
  for (const auto slot : index_.slotsById()) {
    if (config_.map == "best")
      map.push_back({index_.id(slot), best[slot].mean(), best[slot].covariance()});
    else
      map.push_back(mixtureOf(*particles_, slot, index_.id(slot)));
  }
  return map;
}

MapState FastSlam::state() const {
  MapState state{pose(), landmarks(), {}};
  // who loads the map knows nothing of the other particles: their spread belongs to it
  const auto slots = index_.slotsById();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    auto& landmark = state.landmarks[i];
    landmark.covariance = mixtureAbout(landmark.position, *particles_, slots[i]);
  }
  return state;
}

std::vector<Pose2> FastSlam::particles() const {
  std::vector<Pose2> poses;
  poses.reserve(particles_->size());
  for (std::size_t i = 0; i < particles_->size(); ++i) poses.push_back((*particles_)[i].pose);
  return poses;
}

}  // namespace slam::particle_filter
