// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/pose_gaussian.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam::particle_filter {

Pose2 PoseGaussian::sample(RandomStream& random) const {
  const Eigen::LLT<Eigen::Matrix3d> L(covariance);
  if (L.info() != Eigen::Success) return mean;  // nothing is uncertain
  const double x = random.gaussian(), y = random.gaussian(), theta = random.gaussian();
  return Pose2::fromVector(mean.vector() + L.matrixL() * Eigen::Vector3d(x, y, theta));
}

double PoseGaussian::logDensity(const Pose2& pose) const {
  const Eigen::LLT<Eigen::Matrix3d> L(covariance);
  Eigen::Vector3d d = pose.vector() - mean.vector();
  d.z() = wrapAngle(d.z());
  L.matrixL().solveInPlace(d);
  const double log_root_determinant =
      std::log(L.matrixLLT()(0, 0) * L.matrixLLT()(1, 1) * L.matrixLLT()(2, 2));
  return -0.5 * d.squaredNorm() - log_root_determinant - 1.5 * std::log(2.0 * M_PI);
}

}  // namespace slam::particle_filter
