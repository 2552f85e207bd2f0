// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::particle_filter {

/// The landmarks' numbers, in the order in which they were first seen, and their ids. One for all
/// particles, of which each may have other landmarks: what several of them begin with the same
/// observation is the same landmark, what they begin with different ones is not. A number is never
/// given twice, also where no particle has its landmark any more.
class LandmarkIndex {
 public:
  std::size_t size() const { return ids_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const;
  /// Adds a landmark with this id; with a free one where the id is unknown or another landmark's.
  void append(LandmarkId id);
  /// A landmark is not found any more, nor in numbersById(); the particles keep it.
  void retire(std::size_t number) { numbers_.erase(ids_[number]); }
  bool isRetired(std::size_t number) const { return find(ids_[number]) != number; }
  bool hasRetired() const { return numbers_.size() < ids_.size(); }
  void clear();

  LandmarkId id(std::size_t number) const { return ids_[number]; }
  /// The numbers of those that are not retired in the order of the ids.
  std::vector<std::size_t> numbersById() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(ids_, numbers_, largest_id_);
  }

 private:
  std::vector<LandmarkId> ids_;
  std::unordered_map<LandmarkId, std::size_t> numbers_;  // looked up only, never iterated
  LandmarkId largest_id_ = kUnknownId;
};

}  // namespace slam::particle_filter
