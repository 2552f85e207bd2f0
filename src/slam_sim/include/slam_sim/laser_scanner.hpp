// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/robot_model.hpp"

namespace slam::sim {

/// A planar laser: all beams of a scan at one instant.
class LaserScanner {
 public:
  LaserScanner(const FloorPlan& plan, const LaserModel& model) : plan_(plan), model_(model) {}

  /// Ranges [m] from the first beam, the one farthest to the right, to the last. As REP-117 has it,
  /// +Inf is no return, -Inf is too near to measure.
  std::vector<float> scan(const Pose2& T_world_base, RandomStream& random) const;

 private:
  float range(double distance, RandomStream& random) const;

  const FloorPlan& plan_;
  LaserModel model_;
};

}  // namespace slam::sim
