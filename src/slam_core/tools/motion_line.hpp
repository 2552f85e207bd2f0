// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "slam_core/models/motion.hpp"

namespace slam {

/// "END_NS X Y THETA  DX DY DTHETA  SX SY STHETA": the odometry's pose, the increment in the
/// robot's frame and its standard deviations [m, m, rad].
inline std::string motionLine(const Motion& motion) {
  const Eigen::Vector3d pose = motion.odometry_end.vector(), step = motion.increment.vector();
  const Eigen::Vector3d sigma = motion.covariance.diagonal().cwiseSqrt();
  return fmt::format("{} {:.6f} {:.6f} {:.6f}  {:.6f} {:.6f} {:.6f}  {:.6f} {:.6f} {:.6f}\n",
                     motion.end.time_since_epoch().count(), pose.x(), pose.y(), pose.z(), step.x(),
                     step.y(), step.z(), sigma.x(), sigma.y(), sigma.z());
}

}  // namespace slam
