// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/particle_filter/block_pool.hpp"

namespace slam::particle_filter {

/// The path of one particle, newest pose first in memory: a list whose older part is shared with
/// the particles of the same ancestry. Poses that no particle descends from are given back. For one
/// thread.
class SharedPath {
  struct Link {
    StampedPose pose;
    Link* before;
    std::size_t count;
  };

 public:
  /// Shared by all paths that may share their poses; must outlive them.
  class Memory {
   public:
    Memory() : links_(sizeof(Link)) {}
    std::size_t posesInUse() const { return links_.inUse(); }

   private:
    friend class SharedPath;
    BlockPool links_;
  };

  explicit SharedPath(Memory& memory) : memory_(&memory) {}
  SharedPath(const SharedPath& other) : memory_(other.memory_), last_(other.last_) {
    if (last_ != nullptr) ++last_->count;
  }
  SharedPath(SharedPath&& other) noexcept
      : memory_(other.memory_), last_(std::exchange(other.last_, nullptr)) {}
  SharedPath& operator=(SharedPath other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(last_, other.last_);
    return *this;
  }
  ~SharedPath();

  void append(const StampedPose& pose);
  /// In the order of time.
  std::vector<StampedPose> poses() const;

 private:
  Memory* memory_;
  Link* last_ = nullptr;
};

}  // namespace slam::particle_filter
