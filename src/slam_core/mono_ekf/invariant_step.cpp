// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/invariant_step.hpp"

#include "slam_core/geometry/pose2.hpp"

namespace slam::mono_ekf {

Eigen::Vector2d stepped(const Eigen::Vector2d& position, const Eigen::Vector2d& step,
                        double alpha) {
  const Eigen::Vector2d u = step - alpha * turnedLeft(position);
  return Pose2::exp({u.x(), u.y(), alpha}).transform(position);
}

Eigen::Vector2d stepBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double alpha) {
  const Pose2 turn(0.0, 0.0, alpha);
  const Eigen::Vector2d moved = to - turn.transform(from);
  const Eigen::Vector3d screw = Pose2(moved.x(), moved.y(), alpha).log();
  return screw.head<2>() + alpha * turnedLeft(from);
}

}  // namespace slam::mono_ekf
