// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/local_maps.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "slam_core/seif/map_joining.hpp"

namespace slam::seif {
namespace {

SharedPoints sharedOf(const MappedPart& a, const MappedPart& b) {
  SharedPoints shared;
  for (std::size_t j = 0; j < b.landmarks.size(); ++j) {
    const auto found = std::find(a.landmarks.begin(), a.landmarks.end(), b.landmarks[j]);
    if (found != a.landmarks.end())
      shared.emplace_back(static_cast<std::size_t>(found - a.landmarks.begin()), j);
  }
  return shared;
}

}  // namespace

bool LocalMaps::knows(std::size_t landmark) const {
  if (landmark < of_landmark_.size() && !of_landmark_[landmark].empty()) return true;
  const auto nodes = sightingsOf(landmarks_).nodesThatSaw(landmark);
  return std::find(nodes.begin(), nodes.end(), -1) != nodes.end();  // a prior of a loaded map
}

std::size_t LocalMaps::largest() const {
  std::size_t most = 0;
  for (const auto& stored : parts_) most = std::max(most, stored.part.landmarks.size());
  return most;
}

std::vector<std::size_t> LocalMaps::around(const MappedPart& part) const {
  std::vector<std::size_t> places;
  for (const auto landmark : part.landmarks)
    if (landmark < of_landmark_.size())
      places.insert(places.end(), of_landmark_[landmark].begin(), of_landmark_[landmark].end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void LocalMaps::add(MappedPart part) {
  while (join(part)) {
  }
  store(std::move(part));
}

/// Joins a part with that of the others with which it has the fewest landmarks together.
bool LocalMaps::join(MappedPart& part) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t best = kNone, fewest = most_landmarks_ + 1;
  for (const auto place : around(part)) {
    const auto& other = parts_[place].part;
    const auto together =
        part.landmarks.size() + other.landmarks.size() - sharedOf(other, part).size();
    if (together < fewest) {
      fewest = together;
      best = place;
    }
  }
  if (best == kNone) return false;
  const auto& other = parts_[best].part;
  const auto shared = sharedOf(other, part);
  auto map = joined(other.map, part.map, shared);
  if (!map) return false;
  MappedPart both{std::move(*map), other.landmarks, other.poses};
  both.poses.insert(both.poses.end(), part.poses.begin(), part.poses.end());
  for (const auto landmark : part.landmarks)
    if (std::find(other.landmarks.begin(), other.landmarks.end(), landmark) ==
        other.landmarks.end())
      both.landmarks.push_back(landmark);
  remove(best);
  part = std::move(both);
  return true;
}

void LocalMaps::store(MappedPart part) {
  if (part.landmarks.size() + part.poses.size() < 2) return;  // it says nothing of others
  auto keys = part.poses;
  for (const auto landmark : part.landmarks) keys.push_back(keyOf(landmarks_, landmark));
  const auto factor = path_.graph().add(std::make_shared<graph::FreeMap>(keys, part.map));
  if (free_.empty()) {
    free_.push_back(parts_.size());
    parts_.emplace_back();
  }
  const auto place = free_.back();
  free_.pop_back();
  for (const auto landmark : part.landmarks) {
    if (landmark >= of_landmark_.size()) of_landmark_.resize(landmark + 1);
    of_landmark_[landmark].push_back(place);
  }
  parts_[place] = {std::move(part), factor};
  ++size_;
}

void LocalMaps::remove(std::size_t place) {
  auto& [part, factor] = parts_[place];
  path_.graph().remove(factor);
  for (const auto landmark : part.landmarks) {
    auto& places = of_landmark_[landmark];
    places.erase(std::find(places.begin(), places.end(), place));
  }
  parts_[place] = {};
  free_.push_back(place);
  --size_;
}

}  // namespace slam::seif
