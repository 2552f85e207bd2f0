// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/principal_axes.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace slam {
namespace {

template <int N>
PrincipalAxes<N> axesOf(const Eigen::Matrix<double, N, N>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric);
  PrincipalAxes<N> axes{solver.eigenvalues(), solver.eigenvectors()};
  if (solver.info() != Eigen::Success)
    axes.values.setConstant(std::numeric_limits<double>::quiet_NaN());
  return axes;
}

}  // namespace

PrincipalAxes<2> principalAxes(const Eigen::Matrix2d& symmetric) { return axesOf(symmetric); }

PrincipalAxes<3> principalAxes(const Eigen::Matrix3d& symmetric) { return axesOf(symmetric); }

PrincipalAxes<Eigen::Dynamic> principalAxes(const Eigen::MatrixXd& symmetric) {
  return axesOf(symmetric);
}

}  // namespace slam
