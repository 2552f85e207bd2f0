// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/pose_gaussian.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace slam::particle_filter {

PoseGaussian PoseGaussian::moved(const Motion& motion) const {
  PoseGaussian after;
  Eigen::Matrix3d J_x, J_u;
  after.mean = mean.compose(motion.increment, &J_x, &J_u);
  after.covariance = J_x * covariance * J_x.transpose() + J_u * motion.covariance * J_u.transpose();
  return after;
}

Pose2 PoseGaussian::sample(RandomStream& random) const {
  if (isCertain()) return mean;
  const double x = random.gaussian(), y = random.gaussian(), theta = random.gaussian();
  const Eigen::Vector3d white(x, y, theta);
  const Eigen::LLT<Eigen::Matrix3d> L(covariance);
  if (L.info() == Eigen::Success) return Pose2::fromVector(mean.vector() + L.matrixL() * white);
  // certain in some direction, to rounding: that one stays as it is
  const Eigen::LDLT<Eigen::Matrix3d> pivoted(covariance);
  const Eigen::Vector3d scaled = pivoted.vectorD().cwiseMax(0.0).cwiseSqrt().cwiseProduct(white);
  const Eigen::Vector3d d = pivoted.transpositionsP().transpose() * (pivoted.matrixL() * scaled);
  return Pose2::fromVector(mean.vector() + d);
}

double PoseGaussian::logDensity(const Pose2& pose) const {
  // a direction without any uncertainty gets a little, below what a pose can be known to
  constexpr double kSmallestVariance = 1e-18;
  Eigen::LLT<Eigen::Matrix3d> L(covariance);
  if (L.info() != Eigen::Success)
    L.compute(covariance +
              (kSmallestVariance + 1e-12 * covariance.trace()) * Eigen::Matrix3d::Identity());
  Eigen::Vector3d d = difference(pose, mean);
  L.matrixL().solveInPlace(d);
  const double log_root_determinant =
      std::log(L.matrixLLT()(0, 0) * L.matrixLLT()(1, 1) * L.matrixLLT()(2, 2));
  return -0.5 * d.squaredNorm() - log_root_determinant - 1.5 * std::log(2.0 * M_PI);
}

}  // namespace slam::particle_filter
