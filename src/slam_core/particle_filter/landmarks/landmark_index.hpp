// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::particle_filter {

/// Which slot of the particles' maps holds which landmark. One for all particles: what is seen by
/// its own id is new to all of them at once.
class LandmarkIndex {
 public:
  std::size_t size() const { return ids_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const;
  void append(LandmarkId id);
  void clear();

  LandmarkId id(std::size_t slot) const { return ids_[slot]; }
  /// The slots in the order of their ids.
  std::vector<std::size_t> slotsById() const;

 private:
  std::vector<LandmarkId> ids_;
  std::unordered_map<LandmarkId, std::size_t> slots_;  // looked up only, never iterated
};

}  // namespace slam::particle_filter
