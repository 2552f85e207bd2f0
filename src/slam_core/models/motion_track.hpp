// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>

#include "slam_core/models/motion.hpp"

namespace slam {

/// The last motions of an odometry source, from which the motion between any two stamps follows.
class MotionTrack {
 public:
  void add(const Motion& motion);
  void clear() { motions_.clear(); }

  /// Up to where motion is known.
  std::optional<Stamp> end() const;
  /// The motions that lie between, composed; the outer ones are split. Nothing where they do not
  /// cover all of it without a hole.
  std::optional<Motion> between(Stamp start, Stamp end) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(motions_);
  }

 private:
  std::deque<Motion> motions_;
};

}  // namespace slam
