// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/filter_pose.hpp"

#include <cmath>

namespace slam {

FilterPose FilterPose::of(Stamp stamp, const Pose2& T_map_base) {
  return {stamp, T_map_base.x(), T_map_base.y(), std::sin(T_map_base.theta() / 2),
          std::cos(T_map_base.theta() / 2)};
}

Pose2 FilterPose::pose() const { return {x, y, std::atan2(2.0 * qw * qz, qw * qw - qz * qz)}; }

}  // namespace slam
