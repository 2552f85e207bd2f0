// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// Holds the largest speed and turn rate of a robot's base. Twists are (vx, vy, omega) [m/s, m/s,
/// rad/s].
class SpeedLimit {
 public:
  SpeedLimit() = default;
  /// @param speed [m/s] @param turn_rate [rad/s]
  SpeedLimit(double speed, double turn_rate) : speed_(speed), turn_rate_(turn_rate) {}

  /// How large a step is in parts of what the robot can do within the interval; above 1 it cannot.
  /// Stamps of messages that were sent in bursts may be a tenth of a second wrong.
  double shareOf(const Pose2& step, Duration interval) const;
  bool allows(const Eigen::Vector3d& twist) const;
  /// The twist of the same direction and turn that the robot can do; speed and turn rate are cut
  /// each by itself.
  Eigen::Vector3d cut(const Eigen::Vector3d& twist) const;

 private:
  double speed_ = 0.0, turn_rate_ = 0.0;
};

}  // namespace slam
