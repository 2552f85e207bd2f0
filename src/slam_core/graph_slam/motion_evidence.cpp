// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/motion_evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {

Eigen::Matrix3d informationBeyond(const Eigen::Matrix3d& P, const Eigen::Matrix3d& used) {
  constexpr double kLeast = 1e-6;  // [1/m^2], [1/rad^2]
  const Eigen::Matrix3d left = symmetric(P.inverse() - used.inverse());
  const auto [values, V] = principalAxes(left);
  return symmetric(V * values.cwiseMax(kLeast).asDiagonal() * V.transpose());
}

bool contradict(const PoseEstimate& a, const PoseEstimate& b) {
  constexpr double kGate = 16.27;  // three degrees of freedom
  const Eigen::Vector3d error = a.pose.between(b.pose).log();
  const Eigen::Matrix3d S =
      twistCovariance(a.pose, a.covariance) + twistCovariance(b.pose, b.covariance);
  return error.dot(S.llt().solve(error)) > kGate;
}

}  // namespace slam::graph_slam
