// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam::test {

/// The Jacobian of f at x by central differences. `difference` subtracts two results where a plain
/// minus would not do (angles).
template <class Function, class Difference>
Eigen::MatrixXd numericJacobian(const Function& f, const Eigen::VectorXd& x,
                                const Difference& difference) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd J;
  for (Eigen::Index column = 0; column < x.size(); ++column) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(x.size());
    step(column) = kStep;
    const Eigen::VectorXd slope = difference(f(x + step), f(x - step)) / (2 * kStep);
    if (J.size() == 0) J.resize(slope.size(), x.size());
    J.col(column) = slope;
  }
  return J;
}

}  // namespace slam::test
