// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/robot_model.hpp"

namespace slam::sim {

/// What a laser tells of a scan, from the first beam, the one farthest to the right, to the last.
struct LaserReadings {
  std::vector<float> ranges;  ///< [m]; as REP-117 has it, +Inf is no return, -Inf is too near
  /// of what came back, 1000 from a white wall at 1 m; empty in a world without reflectors
  std::vector<float> intensities;
};

/// A planar laser: all beams of a scan at one instant.
class LaserScanner {
 public:
  LaserScanner(const FloorPlan& plan, const LaserModel& model) : plan_(plan), model_(model) {}

  LaserReadings scan(const Pose2& T_world_base, RandomStream& random) const;

 private:
  float range(double distance, RandomStream& random) const;
  static float intensity(const FloorPlan::RayEnd& end, RandomStream& random);

  const FloorPlan& plan_;
  LaserModel model_;
};

}  // namespace slam::sim
