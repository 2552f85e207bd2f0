// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/relocalisation/local_landmarks.hpp"

namespace slam::relocalisation::test {

constexpr double kSigma = 0.03;  // of map and sightings [m]

/// Landmarks at random places of a hall, with ids from 1 on.
inline LandmarkMap hall(std::uint64_t seed, int count, double edge) {
  RandomStream random(seed, 0);
  LandmarkMap map;
  for (int i = 0; i < count; ++i)
    map.push_back({i + 1,
                   {edge * random.uniform(), edge * random.uniform()},
                   1e-4 * Eigen::Matrix2d::Identity()});
  return map;
}

/// The landmarks of a map within a distance of the robot, as it sees them.
inline std::vector<LocalLandmark> seenFrom(const Pose2& robot, const LandmarkMap& map, double reach,
                                           RandomStream& random) {
  std::vector<LocalLandmark> seen;
  for (const auto& landmark : map) {
    const Eigen::Vector2d place = robot.inverse().transform(landmark.position);
    if (place.norm() > reach) continue;
    const Eigen::Vector2d noise(random.gaussian(), random.gaussian());
    seen.push_back(
        {landmark.id, place + kSigma * noise, kSigma * kSigma * Eigen::Matrix2d::Identity()});
  }
  return seen;
}

/// The same without ids.
inline std::vector<LocalLandmark> nameless(std::vector<LocalLandmark> seen) {
  for (auto& landmark : seen) landmark.id = kUnknownId;
  return seen;
}

}  // namespace slam::relocalisation::test
