// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/map_repeats.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/one_place.hpp"

namespace slam::relocalisation {
namespace {

constexpr std::size_t kMostParts = 16;    // that are looked at
constexpr std::size_t kLandmarks = 8;     // of a part
constexpr std::size_t kMostRepeats = 16;  // motions that are found, and their inverses

/// The landmarks around a place, in a frame there whose axes are those of the map.
std::vector<association::LocalLandmark> partAround(const LandmarkMap& map,
                                                   const Eigen::Vector2d& place) {
  std::vector<association::LocalLandmark> part;
  for (const auto& landmark : map)
    part.push_back(
        {kUnknownId, landmark.position - place, landmark.covariance, landmark.descriptor});
  const auto end = part.begin() + static_cast<std::ptrdiff_t>(std::min(kLandmarks, part.size()));
  std::partial_sort(part.begin(), end, part.end(), [](const auto& a, const auto& b) {
    return a.position.squaredNorm() < b.position.squaredNorm();
  });
  part.erase(end, part.end());
  return part;
}

bool isAmong(const std::vector<Pose2>& motions, const Pose2& motion) {
  return std::any_of(motions.begin(), motions.end(),
                     [&](const Pose2& other) { return areOnePlace(other, motion); });
}

}  // namespace

std::vector<Pose2> repeatsOf(const LandmarkMap& map, const association::ConstellationSearch& search,
                             double at_least) {
  std::vector<Pose2> repeats;
  const std::size_t step = std::max<std::size_t>(1, map.size() / kMostParts);
  for (std::size_t i = 0; i < map.size() && repeats.size() < 2 * kMostRepeats; i += step) {
    const Pose2 here(map[i].position.x(), map[i].position.y(), 0.0);
    for (const auto& place : search.placesOf(partAround(map, map[i].position))) {
      const Pose2 motion = place.robot.pose * here.inverse();
      if (place.log_odds < at_least || areOnePlace(place.robot.pose, here) ||
          isAmong(repeats, motion))
        continue;
      repeats.push_back(motion);
      repeats.push_back(motion.inverse());
    }
  }
  return repeats;
}

}  // namespace slam::relocalisation
