// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/trials.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace slam::association {
namespace {

constexpr double kTrackGate = 18.4;        ///< squared Mahalanobis distance, two degrees of freedom
constexpr double kSeenShare = 0.7;         ///< probability that a landmark in view is seen
constexpr double kAccepted = 6.9;          ///< score of a landmark: 1000 to 1
constexpr double kRejected = -3.0;         ///< score at which a track is dropped
constexpr double kHighest = 10.0;          ///< score that no track goes beyond
constexpr std::size_t kMostTracks = 1000;  ///< tracks
constexpr double kStraysRate = 0.02;
constexpr std::size_t kNoTrack = std::numeric_limits<std::size_t>::max();

double densityOf(double nis, const Eigen::Matrix2d& S) {
  return std::exp(-0.5 * nis) / (2.0 * M_PI * std::sqrt(S.determinant()));
}

}  // namespace

void Trials::move(const Motion& motion) {
  const auto back = motion.increment.inverse();
  const Eigen::Matrix2d turn = back.rotation();
  for (auto& track : tracks_) {
    track.place = back.transform(track.place);
    Eigen::Matrix<double, 2, 3> J;  // by the increment
    J << -turn, Eigen::Vector2d(track.place.y(), -track.place.x());
    track.P = turn * track.P * turn.transpose() + J * motion.covariance * J.transpose();
  }
}

void Trials::see(const LandmarkObservationArray& array, const SensorReach& reach) {
  const auto places = placesOf(array);
  const double density = std::max(strays_, 0.1) / reach.area();
  follow(places, density);
  miss(array.sensor_pose, reach);
  const auto strays = std::count(track_of_.begin(), track_of_.end(), kNoTrack);
  strays_ += kStraysRate * (static_cast<double>(strays) - strays_);
  beginAndDrop(places, density);
}

std::vector<Trials::Place> Trials::placesOf(const LandmarkObservationArray& array) const {
  std::vector<Place> places;
  for (const auto& z : array.observations) {
    Eigen::Matrix2d J;
    const Eigen::Vector2d place =
        model_.invert(Pose2(), array.sensor_pose, z.vector(), nullptr, &J);
    places.push_back({place, J * z.covariance * J.transpose()});
  }
  return places;
}

/// The nearest ones first.
std::vector<Trials::Pair> Trials::pairsOf(const std::vector<Place>& places) const {
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks_.size(); ++t)
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Eigen::Vector2d nu = places[i].place - tracks_[t].place;
      const Eigen::Matrix2d S = tracks_[t].P + places[i].R;
      if (nu.squaredNorm() > kTrackGate * S.trace()) continue;
      const double nis = nu.dot(S.inverse() * nu);
      if (nis <= kTrackGate) pairs.push_back({nis, t, i});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.nis, a.track, a.observation) < std::tie(b.nis, b.track, b.observation);
  });
  return pairs;
}

void Trials::follow(const std::vector<Place>& places, double density) {
  for (auto& track : tracks_) track.is_seen = false;
  track_of_.assign(places.size(), kNoTrack);
  for (const auto& [nis, t, i] : pairsOf(places)) {
    if (tracks_[t].is_seen || track_of_[i] != kNoTrack) continue;
    update(places[i], density, tracks_[t]);
    track_of_[i] = t;
  }
}

void Trials::update(const Place& seen, double density, Track& track) const {
  const Eigen::Vector2d nu = seen.place - track.place;
  const Eigen::Matrix2d S = track.P + seen.R;
  const Eigen::Matrix2d K = track.P * S.inverse();
  const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - K;
  const double ratio = kSeenShare * densityOf(nu.dot(S.inverse() * nu), S) / density;
  track.score = std::min(kHighest, track.score + std::log(ratio));
  track.place += K * nu;
  track.P = rest * track.P * rest.transpose() + K * seen.R * K.transpose();
  ++track.sightings;
  track.is_seen = true;
}

void Trials::miss(const Pose2& sensor, const SensorReach& reach) {
  const auto T_sensor_base = sensor.inverse();
  for (auto& track : tracks_)
    if (!track.is_seen && reach.covers(T_sensor_base.transform(track.place)))
      track.score += std::log(1.0 - kSeenShare);
}

/// A track is dropped where it is clutter, or so uncertain that another sighting would say nothing.
void Trials::beginAndDrop(const std::vector<Place>& places, double density) {
  std::vector<Track> kept;
  std::vector<std::size_t> moved(tracks_.size(), kNoTrack);
  const std::size_t excess = tracks_.size() > kMostTracks ? tracks_.size() - kMostTracks : 0;
  for (std::size_t t = excess; t < tracks_.size(); ++t) {
    const auto& track = tracks_[t];
    const bool says_something = kSeenShare * densityOf(0.0, 2.0 * track.P) > density;
    if (track.score < kRejected || !(says_something || track.is_seen)) continue;
    moved[t] = kept.size();
    kept.push_back(track);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (track_of_[i] != kNoTrack) track_of_[i] = moved[track_of_[i]];
    if (track_of_[i] != kNoTrack) continue;
    track_of_[i] = kept.size();
    kept.push_back({places[i].place, places[i].R, 1, 0.0, true});
  }
  tracks_.swap(kept);
}

void Trials::forget() {
  tracks_.clear();
  track_of_.clear();
}

bool Trials::isConfirmed(std::size_t observation) const {
  const auto& track = tracks_[track_of_[observation]];
  return track.sightings >= sightings_ && (sightings_ == 1 || track.score >= kAccepted);
}

}  // namespace slam::association
