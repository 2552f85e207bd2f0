// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/association.hpp"

#include <set>

namespace slam::particle_filter {

void associate(const LandmarkObservationArray& array, const LandmarkIndex& index, bool map_is_fixed,
               Step& step, UpdateStatistics& statistics, Counters& counters) {
  std::set<LandmarkId> seen;
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) {
      ++statistics.unknown;
      counters.add("unknown_id");
    } else if (!seen.insert(z.id).second) {
      counters.add("duplicate");
    } else if (const auto slot = index.find(z.id)) {
      step.sight.matches.push_back({*slot, z});
    } else if (map_is_fixed) {
      ++statistics.unknown;
      counters.add("not_in_map");
    } else {
      step.unseen.push_back(z);
    }
  }
}

}  // namespace slam::particle_filter
