// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include "slam_core/particle_filter/memory/persistent_array.hpp"
#include "slam_core/particle_filter/particles/landmark_estimate.hpp"

namespace slam::particle_filter {

/// A particle's landmarks by slot. The slots are the particle's own; they are in the order of the
/// landmarks' numbers, which are the same in all particles. Where all particles have all landmarks
/// slot and number are the same.
using ParticleMap = PersistentArray<LandmarkEstimate>;

/// Where the landmark with this number is in the map, if it is there.
std::optional<std::size_t> slotOf(std::size_t number, const ParticleMap& map);

/// Null where it is not there.
inline const LandmarkEstimate* find(std::size_t number, const ParticleMap& map) {
  if (number < map.size()) {
    const auto& there = map[number];
    if (there.number == number) return &there;
  }
  const auto slot = slotOf(number, map);
  return slot ? &map[*slot] : nullptr;
}

}  // namespace slam::particle_filter
