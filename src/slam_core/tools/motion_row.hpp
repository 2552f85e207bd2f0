// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "log_rows.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// "motion START_NS END_NS X Y THETA  DX DY DTHETA  SX SY STHETA": the odometry's pose at the end,
/// the increment in the robot's frame and its standard deviations [m, m, rad].
inline std::string motionRow(const Motion& motion) {
  const Eigen::Vector3d pose = motion.odometry_end.vector(), step = motion.increment.vector();
  const Eigen::Vector3d sigma = motion.covariance.diagonal().cwiseSqrt();
  return fmt::format(
      "motion {} {} {:.9g} {:.9g} {:.9g}  {:.9g} {:.9g} {:.9g}  {:.9g} {:.9g} {:.9g}\n",
      nanoseconds(motion.start), nanoseconds(motion.end), pose.x(), pose.y(), pose.z(), step.x(),
      step.y(), step.z(), sigma.x(), sigma.y(), sigma.z());
}

/// "pose STAMP_NS X Y THETA" [m, m, rad].
inline std::string poseRow(Stamp stamp, const Pose2& pose) {
  return fmt::format("pose {} {:.9g} {:.9g} {:.9g}\n", nanoseconds(stamp), pose.x(), pose.y(),
                     pose.theta());
}

inline Pose2 poseIn(LogRows& row) {
  const double x = row.number(), y = row.number();
  return {x, y, row.number()};
}

/// The motion of a row as motionRow() writes it; correlations are not in it.
inline Motion motionIn(LogRows& row) {
  Motion motion;
  motion.start = stampFromNanoseconds(row.integer());
  motion.end = stampFromNanoseconds(row.integer());
  motion.odometry_end = poseIn(row);
  motion.increment = poseIn(row);
  motion.odometry_start = motion.odometry_end * motion.increment.inverse();
  for (int i = 0; i < 3; ++i) motion.covariance(i, i) = std::pow(row.number(), 2);
  if (const auto fault = faultOf(motion); !fault.empty()) row.fail(fault);
  return motion;
}

}  // namespace slam
