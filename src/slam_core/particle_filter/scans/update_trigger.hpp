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

  /// @param step since the last scan that was used
  bool isDue(const Pose2& step, Stamp stamp) const {
    if (!last_) return true;
    if (step.position().norm() >= distance_ || std::abs(step.theta()) >= angle_) return true;
    return interval_ > Duration::zero() && stamp - *last_ >= interval_;
  }
  void restart(Stamp stamp) { last_ = stamp; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_);
  }

 private:
  double distance_, angle_;
  Duration interval_;
  std::optional<Stamp> last_;
};

}  // namespace slam::particle_filter
