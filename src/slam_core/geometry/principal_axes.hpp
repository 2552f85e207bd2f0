// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam {

/// It holds the eigenvalues of a symmetric matrix, in increasing order, and the directions that
/// belong to them, of length 1, in the columns. The values are NaN where Eigen finds none, as of a
/// matrix that is not finite. One file computes them, since the compiler takes seconds for Eigen's
/// solver in each file that uses it.
template <int N>
struct PrincipalAxes {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> directions;
};

PrincipalAxes<2> principalAxes(const Eigen::Matrix2d& symmetric);
PrincipalAxes<3> principalAxes(const Eigen::Matrix3d& symmetric);
PrincipalAxes<Eigen::Dynamic> principalAxes(const Eigen::MatrixXd& symmetric);

/// The variance in the most uncertain direction.
inline double largestVariance(const Eigen::Matrix2d& covariance) {
  return principalAxes(covariance).values(1);
}

}  // namespace slam
