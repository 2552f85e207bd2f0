// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/jump_limit.hpp"

#include <algorithm>
#include <cmath>

namespace slam {

const Pose2& JumpLimit::follow(Stamp stamp, const Pose2& T_map_base, const Pose2& T_odom_base) {
  constexpr double kLongest = 1.0;  // [s]
  const Pose2 shown = T_map_odom_ * T_odom_base;
  const Pose2 correction = shown.between(T_map_base);
  double share = 1.0;
  if (last_ && limits_.speed > 0.0)
    share = shareOf(correction, std::clamp(seconds(stamp - *last_), 0.0, kLongest));
  last_ = stamp;
  const Pose2 T_map_base_next = share < 1.0 ? shown * correction.part(share) : T_map_base;
  T_map_odom_ = T_map_base_next * T_odom_base.inverse();
  return T_map_odom_;
}

double JumpLimit::shareOf(const Pose2& displacement, double time) const {
  const Eigen::Vector3d twist = displacement.log();
  const double length = twist.head<2>().norm(), angle = std::abs(twist.z());
  double share = 1.0;
  if (length > limits_.speed * time) share = limits_.speed * time / length;
  if (angle * share > limits_.turn_rate * time) share = limits_.turn_rate * time / angle;
  return share;
}

}  // namespace slam
