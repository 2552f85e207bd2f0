// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/particle_filter/memory/block_pool.hpp"

namespace slam::particle_filter {

/// The path of one particle. It holds the particle's poses only of the steps that taught something;
/// in between, all particles moved as the odometry says, which stands once for all of them. The
/// poses are a list, newest first in memory, whose older part is shared with the particles of the
/// same ancestry; those that no particle descends from are given back. For one thread.
class SharedPath {
  struct Link {
    Pose2 pose;
    std::size_t step;
    Link* before;
    std::size_t count;
  };

 public:
  /// Shared by all paths that may share their poses; must outlive them.
  class Memory {
   public:
    Memory() : links_(sizeof(Link)) {}

    /// A step that all paths take.
    /// @param increment of the odometry since the step before
    void addStep(Stamp stamp, const Pose2& increment);
    /// Only when all paths are empty.
    void clearSteps() { steps_.clear(); }

    std::size_t steps() const { return steps_.size(); }
    std::size_t posesInUse() const { return links_.inUse(); }

    template <class Archive>
    void persist(Archive& archive) {
      archive(steps_);
    }

   private:
    friend class SharedPath;
    struct Step {
      Stamp stamp;
      Pose2 odometry;  ///< since the first step

      template <class Archive>
      void persist(Archive& archive) {
        archive(stamp, odometry);
      }
    };
    BlockPool links_;
    std::vector<Step> steps_;
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

  /// The pose after the last step; the first one for a step counts.
  void append(const Pose2& pose);

  /// A pose for each step in the order of time: where none was appended, as the odometry says, with
  /// its error spread evenly over the way to the next.
  /// @param now after the last step, counts where nothing was appended for it
  std::vector<StampedPose> poses(const Pose2& now) const;

  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (Archive::kReads) *this = SharedPath(*memory_);
    Link** place = &last_;
    for (; archive.refer(*place); place = &(*place)->before) {
      if constexpr (Archive::kReads)
        archive.bind(*place = new (memory_->links_.allocate(0)) Link{Pose2(), 0, nullptr, 1});
      archive((*place)->pose, (*place)->step);
    }
    if constexpr (Archive::kReads)
      if (*place != nullptr) ++(*place)->count;
  }

 private:
  struct Knot {
    std::size_t step;
    Pose2 pose;
  };
  std::vector<Knot> knots(const Pose2& now) const;

  Memory* memory_;
  Link* last_ = nullptr;
};

}  // namespace slam::particle_filter
