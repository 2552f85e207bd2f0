// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// Whether two poses are one place of a robot, as far as different searches would tell it.
inline bool areOnePlace(const Pose2& a, const Pose2& b) {
  constexpr double kShift = 0.5, kTurn = 0.3;  // [m], [rad]
  return (a.position() - b.position()).norm() < kShift &&
         std::abs(wrapAngle(a.theta() - b.theta())) < kTurn;
}

}  // namespace slam
