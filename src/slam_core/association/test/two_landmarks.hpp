// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::association::test {

/// Two landmarks [m], far from one another.
inline std::vector<Eigen::Vector2d> twoLandmarks() {
  return {Eigen::Vector2d(3, 1), Eigen::Vector2d(4, -2)};
}

/// What a sensor at the origin sees of them, 2 cm too far.
inline LandmarkObservationArray observationsOf(const std::vector<Eigen::Vector2d>& landmarks) {
  LandmarkObservationArray array;
  for (const auto& place : landmarks) {
    LandmarkObservation z;
    z.range = place.norm() + 0.02;
    z.bearing = std::atan2(place.y(), place.x());
    z.covariance = Eigen::Vector2d(0.0025, 0.0001).asDiagonal();
    array.observations.push_back(z);
  }
  return array;
}

/// One more observation, of something that is nowhere near the map.
inline void addStray(LandmarkObservationArray& array) {
  array.observations.emplace_back(array.observations.front());
  array.observations.back().range = 80.0;
}

}  // namespace slam::association::test
