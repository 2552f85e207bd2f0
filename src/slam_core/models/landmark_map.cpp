// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_map.hpp"

namespace slam {

PoseEstimate bounded(PoseEstimate estimate, const Eigen::Vector3d& largest_sigmas) {
  const Eigen::Vector3d sigma = estimate.covariance.diagonal().cwiseSqrt();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (sigma(i) <= largest_sigmas(i)) continue;
    estimate.covariance.row(i) *= largest_sigmas(i) / sigma(i);
    estimate.covariance.col(i) *= largest_sigmas(i) / sigma(i);
  }
  return estimate;
}

}  // namespace slam
