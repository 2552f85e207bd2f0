// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_matcher.hpp"

namespace slam::grid_map {
namespace {

/// Tries a step along each axis of the robot's frame; takes those that help.
bool climb(const MatchObjective& objective, double position, double heading, ScanMatch& best) {
  bool has_climbed = false;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Pose2 step(axis == 0 ? sign * position : 0.0, axis == 1 ? sign * position : 0.0,
                       axis == 2 ? sign * heading : 0.0);
      const Pose2 pose = best.pose * step;
      const double value = objective.log(pose);
      if (!(value > best.log_value)) continue;
      best = {pose, value};
      has_climbed = true;
      break;
    }
  return has_climbed;
}

}  // namespace

ScanMatch HillClimbing::from(const Pose2& start, const MatchObjective& objective) const {
  ScanMatch best{start, objective.log(start)};
  double position = steps_.position, heading = steps_.heading;
  for (int halvings = 0; halvings < steps_.halvings;) {
    if (climb(objective, position, heading, best)) continue;
    ++halvings;
    position /= 2.0;
    heading /= 2.0;
  }
  return best;
}

}  // namespace slam::grid_map
