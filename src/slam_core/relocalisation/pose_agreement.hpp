// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::relocalisation {

/// Whether two estimates are compatible with one pose (chi-square gate). Their errors are taken to
/// be independent.
inline bool agree(const PoseEstimate& a, const PoseEstimate& b) {
  constexpr double kPoseGate = 16.27;  // 0.999 of chi-square with three degrees of freedom
  Eigen::Vector3d e = a.pose.vector() - b.pose.vector();
  e.z() = wrapAngle(e.z());
  const Eigen::Matrix3d S = a.covariance + b.covariance;
  return e.dot(S.llt().solve(e)) <= kPoseGate;
}

}  // namespace slam::relocalisation
