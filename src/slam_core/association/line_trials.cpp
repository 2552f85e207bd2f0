// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/line_trials.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace slam::association {
namespace {

constexpr double kLineGate = 18.4;  // squared Mahalanobis distance, two degrees of freedom
constexpr int kForgotten = 20;      // arrays
constexpr std::size_t kMostLineTracks = 1000;  // the newest

}  // namespace

/// A line of the robot's frame looks from the next pose as the observation model says.
void LineTrials::move(const Motion& motion) {
  ObservationModel::Jacobian23 J_increment;
  Eigen::Matrix2d J_m;
  for (auto& track : tracks_) {
    track.m = model_.predict(motion.increment, Pose2(), track.m, &J_increment, &J_m);
    track.P =
        J_m * track.P * J_m.transpose() + J_increment * motion.covariance * J_increment.transpose();
  }
}

void LineTrials::see(const std::vector<LandmarkObservation>& lines, const Pose2& sensor) {
  is_confirmed_.clear();
  for (auto& track : tracks_) ++track.unseen;
  const auto known = tracks_.size();
  for (const auto& z : lines) {
    Eigen::Matrix2d J;
    Track seen;
    seen.m = model_.invert(Pose2(), sensor, z.vector(), nullptr, &J);
    seen.P = J * z.covariance * J.transpose();
    const auto track = nearest(seen, known);
    if (track < known)
      update(seen, tracks_[track]);
    else
      tracks_.push_back(seen);
    is_confirmed_.push_back((track < known ? tracks_[track].sightings : 1) >= sightings_);
  }
  dropOld();
}

bool LineTrials::isConfirmed(std::size_t line) const { return is_confirmed_[line]; }

/// @return the track of the first `end` that the line is most likely of; `end` where of none
std::size_t LineTrials::nearest(const Track& seen, std::size_t end) const {
  std::size_t best = end;
  double least = kLineGate;
  for (std::size_t i = 0; i < end; ++i) {
    const Eigen::Vector2d nu = model_.innovation(seen.m, tracks_[i].m);
    const double nis = nu.dot((tracks_[i].P + seen.P).inverse() * nu);
    if (!(nis <= least)) continue;
    least = nis;
    best = i;
  }
  return best;
}

void LineTrials::update(const Track& seen, Track& track) const {
  const Eigen::Vector2d nu = model_.innovation(seen.m, track.m);
  const Eigen::Matrix2d K = track.P * (track.P + seen.P).inverse();
  const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - K;
  track.m += K * nu;
  track.P = rest * track.P * rest.transpose() + K * seen.P * K.transpose();
  if (track.unseen > 0) ++track.sightings;  // two parts of a line in one array are one sighting
  track.unseen = 0;
}

void LineTrials::dropOld() {
  const auto is_old = [](const Track& track) { return track.unseen > kForgotten; };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), is_old), tracks_.end());
  if (tracks_.size() > kMostLineTracks)
    tracks_.erase(tracks_.begin(), tracks_.end() - static_cast<std::ptrdiff_t>(kMostLineTracks));
}

}  // namespace slam::association
