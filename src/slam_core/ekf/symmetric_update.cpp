// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/symmetric_update.hpp"

namespace slam::ekf {

void subtractOuterProductLower(const Eigen::MatrixXd& W, double* P, Eigen::Index size,
                               Eigen::Index stride) {
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> lower(P, size, size,
                                                             Eigen::OuterStride<>(stride));
  lower.selfadjointView<Eigen::Lower>().rankUpdate(W.topRows(size), -1.0);
}

}  // namespace slam::ekf
