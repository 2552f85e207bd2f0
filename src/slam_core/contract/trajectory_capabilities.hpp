// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/stamped_pose.hpp"

namespace slam {

/// The capability of a back-end whose belief is a set of samples.
class PoseSampler {
 public:
  virtual ~PoseSampler() = default;
  virtual std::vector<Pose2> particles() const = 0;  ///< in the map frame
};

/// The capability of a back-end that revises the past.
class PathReviser {
 public:
  virtual ~PathReviser() = default;
  /// The most likely path as it is estimated now, with a pose for each step since the map was begun
  /// or loaded.
  virtual std::vector<StampedPose> path() const = 0;
};

}  // namespace slam
