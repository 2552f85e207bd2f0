// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::particle_filter {

/// Says when a scan is worth an update: the first one, and after that when the robot has gone or
/// turned far enough, or enough time has passed, since the last that was used.
class UpdateTrigger {
 public:
  /// @param distance [m], @param angle [rad], @param interval 0: never for the time alone
  UpdateTrigger(double distance, double angle, Duration interval)
      : distance_(distance), angle_(angle), interval_(interval) {}

  void move(const Pose2& increment) {
    way_ += increment.position().norm();
    turn_ += std::abs(increment.theta());
  }
  bool isDue(Stamp stamp) const {
    if (!last_ || way_ >= distance_ || turn_ >= angle_) return true;
    return interval_ > Duration::zero() && stamp - *last_ >= interval_;
  }
  void restart(Stamp stamp) {
    last_ = stamp;
    way_ = turn_ = 0.0;
  }

 private:
  double distance_, angle_;
  Duration interval_;
  std::optional<Stamp> last_;
  double way_ = 0.0, turn_ = 0.0;
};

}  // namespace slam::particle_filter
