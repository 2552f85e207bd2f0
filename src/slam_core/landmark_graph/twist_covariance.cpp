// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/twist_covariance.hpp"

#include "slam_core/geometry/covariance.hpp"

namespace slam::landmark_graph {

Eigen::Matrix3d twistCovariance(const Pose2& pose, const Eigen::Matrix3d& of_coordinates) {
  constexpr double kSmallestSigma = 1e-6;  // [m], [rad]
  const Eigen::Matrix3d J_inverse = pose.twistJacobian().transpose();
  return J_inverse * of_coordinates * J_inverse.transpose() +
         kSmallestSigma * kSmallestSigma * Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d coordinateCovariance(const Pose2& pose, const Eigen::Matrix3d& of_twist) {
  const Eigen::Matrix3d J = pose.twistJacobian();
  return symmetric(J * of_twist * J.transpose());
}

}  // namespace slam::landmark_graph
