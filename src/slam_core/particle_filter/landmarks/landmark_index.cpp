// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/landmark_index.hpp"

#include <algorithm>
#include <numeric>

namespace slam::particle_filter {

std::optional<std::size_t> LandmarkIndex::find(LandmarkId id) const {
  const auto found = slots_.find(id);
  if (found == slots_.end()) return std::nullopt;
  return found->second;
}

void LandmarkIndex::append(LandmarkId id) {
  slots_[id] = ids_.size();
  ids_.push_back(id);
}

void LandmarkIndex::clear() {
  ids_.clear();
  slots_.clear();
}

std::vector<std::size_t> LandmarkIndex::slotsById() const {
  std::vector<std::size_t> slots(ids_.size());
  std::iota(slots.begin(), slots.end(), std::size_t{0});
  std::sort(slots.begin(), slots.end(),
            [this](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
  return slots;
}

}  // namespace slam::particle_filter
