// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/landmark_index.hpp"

#include <algorithm>
#include <numeric>

namespace slam::particle_filter {

std::optional<std::size_t> LandmarkIndex::find(LandmarkId id) const {
  const auto found = numbers_.find(id);
  if (found == numbers_.end()) return std::nullopt;
  return found->second;
}

void LandmarkIndex::append(LandmarkId id) {
  const bool is_own = id != kUnknownId && !find(id);
  const auto given = is_own ? id : largest_id_ + 1;
  largest_id_ = std::max(largest_id_, given);
  numbers_[given] = ids_.size();
  ids_.push_back(given);
}

void LandmarkIndex::clear() {
  ids_.clear();
  numbers_.clear();
  largest_id_ = kUnknownId;
}

std::vector<std::size_t> LandmarkIndex::numbersById() const {
  std::vector<std::size_t> numbers(ids_.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto is_retired = [this](std::size_t number) { return isRetired(number); };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_retired), numbers.end());
  std::sort(numbers.begin(), numbers.end(),
            [this](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
  return numbers;
}

}  // namespace slam::particle_filter
