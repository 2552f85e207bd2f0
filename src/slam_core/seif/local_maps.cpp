// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/local_maps.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"

namespace slam::seif {
namespace {

std::size_t sizeOf(const MappedPart& part) { return part.landmarks.size() + part.poses.size(); }

/// The poses that both have are marginalised.
std::size_t sizeTogether(const MappedPart& a, const MappedPart& b) {
  const SharedPart shared(a, b);
  return sizeOf(a) + sizeOf(b) - shared.in_first.size() - 2 * shared.poses.size();
}

}  // namespace

std::optional<MappedPart> LocalMaps::joined(const MappedPart& first, const MappedPart& second,
                                            const std::vector<graph::Key>& marginalised) const {
  if (sizeTogether(first, second) > limits_.landmarks) return std::nullopt;
  return seif::joined(first, second, marginalised, limits_.heading);
}

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

std::vector<std::size_t> LocalMaps::partsWith(const std::vector<std::size_t>& landmarks) const {
  std::vector<std::size_t> places;
  for (const auto landmark : landmarks)
    if (landmark < of_landmark_.size())
      places.insert(places.end(), of_landmark_[landmark].begin(), of_landmark_[landmark].end());
  return sortedUnique(std::move(places));
}

std::vector<std::size_t> LocalMaps::around(const std::vector<std::size_t>& landmarks) const {
  auto all = landmarks;
  for (const auto place : partsWith(landmarks)) {
    const auto& others = parts_[place].part.landmarks;
    all.insert(all.end(), others.begin(), others.end());
  }
  return sortedUnique(std::move(all));
}

void LocalMaps::add(MappedPart part) {
  while (join(part)) {
  }
  store(std::move(part));
}

/// The poses between two parts that nothing else holds.
std::vector<graph::Key> LocalMaps::jointsOf(const MappedPart& a, const MappedPart& b) const {
  auto poses = SharedPart(a, b).poses;
  const auto has_prior = [this](graph::Key pose) { return chainOf(path_)[pose].has_prior; };
  poses.erase(std::remove_if(poses.begin(), poses.end(), has_prior), poses.end());
  return poses;
}

/// Joins a part with that of the others with which it has the fewest landmarks together.
/// @return whether there is one
bool LocalMaps::join(MappedPart& part) {
  std::vector<std::pair<std::size_t, std::size_t>> options;  // size together, place
  for (const auto place : partsWith(part.landmarks)) {
    const auto& other = parts_[place].part;
    const auto size = sizeTogether(other, part);
    if (size <= limits_.landmarks) options.emplace_back(size, place);
  }
  std::sort(options.begin(), options.end());
  for (const auto& [size, place] : options) {
    const auto between = jointsOf(parts_[place].part, part);
    auto both = joined(parts_[place].part, part, between);
    if (!both) continue;
    remove(place);
    for (const auto pose : between) chainOf(path_).remove(pose);
    part = std::move(*both);
    return true;
  }
  return false;
}

void LocalMaps::store(MappedPart part) {
  if (sizeOf(part) < 2) return;  // it says nothing of others
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
