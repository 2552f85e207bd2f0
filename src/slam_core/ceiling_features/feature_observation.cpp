// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/feature_observation.hpp"

#include <cmath>

namespace slam::ceiling_features {
namespace {

/// The derivative of a point of the ceiling by the pixel that sees it [m/px].
std::optional<Eigen::Matrix2d> jacobian(const Eigen::Vector2d& pixel, const CeilingView& ceiling) {
  Eigen::Matrix2d J_point_pixel;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = 0.5 * Eigen::Vector2d::Unit(i);
    const auto before = ceiling.toCeiling(pixel - step), after = ceiling.toCeiling(pixel + step);
    if (!before || !after) return std::nullopt;
    J_point_pixel.col(i) = *after - *before;
  }
  return J_point_pixel;
}

}  // namespace

std::optional<LandmarkObservation> observationOf(const Eigen::Vector2d& pixel,
                                                 const CeilingView& ceiling,
                                                 const CeilingFeaturesConfig& config) {
  const auto point = ceiling.toCeiling(pixel);
  const auto J_point_pixel = jacobian(pixel, ceiling);
  if (!point || !J_point_pixel) return std::nullopt;
  const Eigen::Matrix2d J = config.pixel_sigma * *J_point_pixel;
  const double uneven = config.relative_sigma * ceiling.height();
  const Eigen::Matrix2d P = J * J.transpose() + uneven * uneven * Eigen::Matrix2d::Identity();

  const Eigen::Vector2d offset = *point - ceiling.origin();
  LandmarkObservation z;
  z.range = offset.norm();
  z.bearing = std::atan2(offset.y(), offset.x());
  const double c = offset.x() / z.range, s = offset.y() / z.range;
  Eigen::Matrix2d J_z_point;
  J_z_point << c, s, -s / z.range, c / z.range;
  z.covariance = J_z_point * P * J_z_point.transpose();
  z.covariance(0, 1) = z.covariance(1, 0);
  return z;
}

}  // namespace slam::ceiling_features
