// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/covariance.hpp"

#include <Eigen/Cholesky>

namespace slam {

Eigen::Vector2d withCovariance(const Eigen::Matrix2d& P, const Eigen::Vector2d& white) {
  return P.llt().matrixL() * white;
}

Eigen::Vector3d withCovariance(const Eigen::Matrix3d& P, const Eigen::Vector3d& white) {
  return P.llt().matrixL() * white;
}

double squaredDistance(const Eigen::Vector3d& e, const Eigen::Matrix3d& P) {
  return e.dot(P.llt().solve(e));
}

}  // namespace slam
