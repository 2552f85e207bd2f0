// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/particle_map.hpp"

#include <algorithm>

namespace slam::particle_filter {

std::optional<std::size_t> slotOf(std::size_t number, const ParticleMap& map) {
  // numbers grow by at least one from slot to slot: none is below its slot
  std::size_t first = 0, last = std::min(number + 1, map.size());
  if (last > number && map[number].number == number) return number;
  while (first < last) {
    const auto middle = first + (last - first) / 2;
    if (map[middle].number < number)
      first = middle + 1;
    else
      last = middle;
  }
  if (first < map.size() && map[first].number == number) return first;
  return std::nullopt;
}

}  // namespace slam::particle_filter
