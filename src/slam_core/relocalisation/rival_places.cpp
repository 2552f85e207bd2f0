// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/rival_places.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/geometry/one_place.hpp"

namespace slam::relocalisation {
namespace {

constexpr std::size_t kMostPlaces = 32;  ///< places that are followed
constexpr std::size_t kOnTheMap = 2;     ///< so many landmarks within reach contradict, if unseen

}  // namespace

void RivalPlaces::move(const Motion& motion) {
  for (auto& pose : poses_) pose = pose * motion.increment;
}

bool RivalPlaces::add(const Pose2& place) {
  const auto is_same = [&](const Pose2& pose) { return areOnePlace(pose, place); };
  const auto known = std::find_if(poses_.begin(), poses_.end(), is_same);
  if (known != poses_.end()) {
    *known = place;
    return false;
  }
  if (poses_.size() < kMostPlaces) poses_.push_back(place);
  return true;
}

void RivalPlaces::add(const std::vector<Pose2>& places, const std::vector<Pose2>& repeats) {
  for (const auto& place : places) {
    if (!add(place)) continue;
    for (const auto& repeat : repeats) add(repeat * place);
  }
}

void RivalPlaces::check(const association::ConstellationEvidence& evidence,
                        const std::vector<association::LocalLandmark>& around,
                        const association::SensorReach& reach) {
  for (const auto& pose : std::exchange(poses_, {}))
    if (evidence.within(reach, pose) < kOnTheMap)
      add(pose);
    else if (const auto place = evidence.near(pose, around, reach); place && place->log_odds > 0.0)
      add(place->robot.pose);
}

bool RivalPlaces::hasOtherThan(const Pose2& place) const {
  return std::any_of(poses_.begin(), poses_.end(),
                     [&](const Pose2& pose) { return !areOnePlace(pose, place); });
}

}  // namespace slam::relocalisation
