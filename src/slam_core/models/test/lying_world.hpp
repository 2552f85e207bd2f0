// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "slam_core/models/test/simulated_world.hpp"

namespace slam::test {

/// How the markers of a world lie.
struct Lies {
  std::map<LandmarkId, LandmarkId> printed_as;  ///< another id than their own
  double false_ids = 0.0;                       ///< share of observations with an id that was drawn
  double false_ranges = 0.0;                    ///< share of observations that are off by a metre
  double scale = 1.0;                           ///< of all ranges
  std::map<LandmarkId, Eigen::Vector2d> moved;  ///< where they stand now, in the map frame [m]
};

/// The simulated world where markers are not what their observations say.
class LyingWorld {
 public:
  explicit LyingWorld(std::uint64_t seed) : world_(seed), random_(seed, 7) {}

  const std::map<LandmarkId, Eigen::Vector2d>& landmarks() const { return world_.landmarks(); }
  Lies& lies() { return lies_; }

  SimulatedStep next() {
    auto step = world_.next();
    auto& observations = step.observations.observations;
    move(step);
    for (auto& z : observations) {
      const auto printed = lies_.printed_as.find(z.id);
      if (printed != lies_.printed_as.end()) z.id = printed->second;
      z.range *= lies_.scale;
      if (random_.uniform() < lies_.false_ids) z.id = drawnId();
      if (random_.uniform() < lies_.false_ranges) z.range += random_.uniform() < 0.5 ? -1.0 : 1.0;
      z.range = std::max(z.range, 0.1);
    }
    return step;
  }

 private:
  /// One of the world's ids, or one that no marker has.
  LandmarkId drawnId() {
    const auto count = world_.landmarks().size();
    const auto number = static_cast<std::size_t>(2.0 * random_.uniform() * double(count));
    if (number >= count) return LandmarkId(1000 + number);
    return std::next(world_.landmarks().begin(), std::ptrdiff_t(number))->first;
  }

  void move(SimulatedStep& step) {
    auto& observations = step.observations.observations;
    const auto is_moved = [this](const auto& z) { return lies_.moved.count(z.id) > 0; };
    observations.erase(std::remove_if(observations.begin(), observations.end(), is_moved),
                       observations.end());
    const Pose2 T_sensor_map = (step.truth * step.observations.sensor_pose).inverse();
    for (const auto& [id, place] : lies_.moved) {
      const auto seen = T_sensor_map.transform(place);
      if (seen.norm() > 5.0 || seen.norm() < 0.5) continue;
      LandmarkObservation z;
      z.id = id;
      z.range = seen.norm() + 0.05 * random_.gaussian();
      z.bearing = std::atan2(seen.y(), seen.x()) + 0.01 * random_.gaussian();
      z.covariance << 25e-4, 0, 0, 1e-4;
      observations.push_back(z);
    }
  }

  SimulatedWorld world_;
  RandomStream random_;
  Lies lies_;
};

}  // namespace slam::test
