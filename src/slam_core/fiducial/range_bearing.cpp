// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/range_bearing.hpp"

#include <cmath>

namespace slam::fiducial {

std::optional<LandmarkObservation> rangeAndBearing(const Eigen::Vector3d& position,
                                                   const Eigen::Matrix3d& covariance,
                                                   const Eigen::Matrix3d& R_base_camera,
                                                   double max_relative_sigma) {
  const Eigen::Matrix<double, 2, 3> R = R_base_camera.topRows<2>();
  const Eigen::Vector2d offset = R * position;
  const Eigen::Matrix2d P = R * covariance * R.transpose();
  const double range = offset.norm();
  const double variance = 0.5 * P.trace() + std::hypot(0.5 * (P(0, 0) - P(1, 1)), P(0, 1));
  if (!(std::sqrt(variance) <= max_relative_sigma * range) || range == 0.0) return std::nullopt;

  LandmarkObservation z;
  z.range = range;
  z.bearing = std::atan2(offset.y(), offset.x());
  const double c = offset.x() / range, s = offset.y() / range;
  Eigen::Matrix2d J;
  J << c, s, -s / range, c / range;
  z.covariance = J * P * J.transpose();
  z.covariance(0, 1) = z.covariance(1, 0);
  return z;
}

}  // namespace slam::fiducial
