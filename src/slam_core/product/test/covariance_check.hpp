// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>

namespace slam::test {

inline bool isSymmetricPositiveDefinite(const Eigen::MatrixXd& P) {
  return P.allFinite() && (P - P.transpose()).cwiseAbs().maxCoeff() < 1e-12 &&
         Eigen::LLT<Eigen::MatrixXd>(P).info() == Eigen::Success;
}

}  // namespace slam::test
