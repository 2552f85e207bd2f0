// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/gate.hpp"

#include <Eigen/LU>
#include <cmath>

namespace slam::association {

double gateOf(double probability) { return -2.0 * std::log(1.0 - probability); }

double outlierLogLikelihood(double gate, double nis, const Eigen::Matrix2d& S) {
  return -0.5 * gate - (1.0 + 0.5 * gate) * std::log(nis / gate) - std::log(2.0 * M_PI) -
         0.5 * std::log(S.determinant());
}

}  // namespace slam::association
