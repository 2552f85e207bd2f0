// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/arc_jacobian.hpp"

#include <cmath>

#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// The position is V(theta) (x, y), and theta dV/dtheta = R(theta) - V.
Eigen::Matrix3d arcJacobian(const Eigen::Vector3d& twist) {
  const double theta = twist.z();
  const Pose2 end = Pose2::exp(twist);
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J.block<2, 1>(0, 0) = Pose2::exp({1.0, 0.0, theta}).position();
  J.block<2, 1>(0, 1) = Pose2::exp({0.0, 1.0, theta}).position();
  if (std::abs(theta) > 1e-4)
    J.block<2, 1>(0, 2) = (end.rotation() * twist.head<2>() - end.position()) / theta;
  else  // the quotient loses its digits
    J.block<2, 1>(0, 2) =
        0.5 * Eigen::Vector2d(-twist.y(), twist.x()) - theta / 3.0 * twist.head<2>();
  return J;
}

}  // namespace slam
