// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// From `from` to `to`, (x, y, theta) apart, the angle wrapped.
inline Eigen::Vector3d difference(const Pose2& to, const Pose2& from) {
  Eigen::Vector3d d = to.vector() - from.vector();
  d.z() = wrapAngle(d.z());
  return d;
}

}  // namespace slam
