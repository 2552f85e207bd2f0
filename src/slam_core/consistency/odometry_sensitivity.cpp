// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/odometry_sensitivity.hpp"

#include <Eigen/Cholesky>

namespace slam {

void OdometrySensitivity::predict(const PosePrediction& prediction) {
  const auto& F = prediction.F;
  e_ = F * e_;
  D_ = F * D_ * F.transpose() + prediction.Q;
}

/// Relative to the landmarks the pose has the covariance P with H P H^T + R = S. So
/// (H^T S^-1 H)^-1 = P + (H^T R^-1 H)^-1, and an update leaves the share
/// I - K H = (H^T R^-1 H)^-1 H^T S^-1 H of an error.
void OdometrySensitivity::update(const JointInnovation& group) {
  const auto S = group.S.llt();
  const Eigen::Matrix3d believed = group.H.transpose() * S.solve(group.H);
  const Eigen::Matrix3d exact = group.H.transpose() * group.R.llt().solve(group.H);
  const Eigen::Vector3d slope = group.H.transpose() * S.solve(group.nu);
  // Directions that the landmarks in view do not observe are left unchanged.
  constexpr double kSmallestShare = 1e-9;
  const Eigen::Matrix3d unseen = kSmallestShare * exact.trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d left = (exact + unseen).llt().solve(believed + unseen);
  e_ = left * (e_ + D_ * slope);
  D_ = left * D_ * left.transpose();
}

}  // namespace slam
