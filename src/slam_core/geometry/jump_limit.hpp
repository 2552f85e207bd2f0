// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// Spreads corrections of a pose over time: T_map_odom follows the estimate, and moves the robot in
/// the map by at most so much a second of stamps. The limit holds where the robot is, not at the
/// origin of odom, which a small turn moves by metres when it is far away.
class JumpLimit {
 public:
  struct Limits {
    double speed = 0.0;      ///< [m/s]; 0: neither is limited
    double turn_rate = 0.2;  ///< [rad/s]
  };

  explicit JumpLimit(const Limits& limits) : limits_(limits) {}

  /// The next call of follow() leads to the estimate at once, as the first one does.
  void restart() { last_.reset(); }
  /// Called at every step. Where stamps have a gap of more than a second, or go back, a second or
  /// nothing has passed.
  /// @return T_map_odom
  const Pose2& follow(Stamp stamp, const Pose2& T_map_base, const Pose2& T_odom_base);

 private:
  /// The share of a displacement that may be covered in this time [s].
  double shareOf(const Pose2& displacement, double time) const;

  Limits limits_;
  Pose2 T_map_odom_;
  std::optional<Stamp> last_;
};

}  // namespace slam
