// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>

namespace slam {

/// Takes out what rounding has made different on both sides of the diagonal.
inline Eigen::Matrix3d symmetric(const Eigen::Matrix3d& P) { return 0.5 * (P + P.transpose()); }

/// Limits the heading's variance in a covariance of (x, y, theta) to that of a heading that may be
/// anything.
inline Eigen::Matrix3d clampedHeading(const Eigen::Matrix3d& P) {
  constexpr double kUniform = M_PI * M_PI / 3.0;
  if (P(2, 2) <= kUniform) return P;
  const double scale = std::sqrt(kUniform / P(2, 2));
  const Eigen::DiagonalMatrix<double, 3> S(1.0, 1.0, scale);
  return S * P * S;
}

/// @param white noise of covariance I @return noise of covariance P, which is positive definite
Eigen::Vector2d withCovariance(const Eigen::Matrix2d& P, const Eigen::Vector2d& white);
Eigen::Vector3d withCovariance(const Eigen::Matrix3d& P, const Eigen::Vector3d& white);
/// @return the squared Mahalanobis distance, e^T P^-1 e
double squaredDistance(const Eigen::Vector3d& e, const Eigen::Matrix3d& P);

}  // namespace slam
