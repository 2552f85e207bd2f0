// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/odometry_errors.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/principal_axes.hpp"

namespace slam::mono_ekf {
namespace {

constexpr double kShareOfNew = 0.1;  // in the mean turn

/// Variances of a metre and of a radian; the smallest ones where the motions do not tell them
/// apart.
Eigen::Vector2d ratesOf(const Eigen::Matrix2d& products, const Eigen::Vector2d& variances) {
  constexpr double kLeast = 1e-6;  // a smaller part of the larger eigenvalue tells nothing
  const auto [values, directions] = principalAxes(products);
  Eigen::Vector2d rates = Eigen::Vector2d::Zero();
  for (int axis = 0; axis < 2; ++axis)
    if (values(axis) > kLeast * values(1))
      rates += directions.col(axis) * (directions.col(axis).dot(variances) / values(axis));
  return rates.cwiseMax(0.0);
}

}  // namespace

DividedMotion OdometryErrors::divide(const Motion& motion) {
  const double way = motion.increment.position().norm(), turn = motion.increment.theta();
  const Eigen::Vector2d amount(way, std::abs(turn));
  DividedMotion divided{motion};
  if (amount.isZero(0.0)) return divided;
  products_ += amount * amount.transpose();
  variances_ += amount * motion.covariance(2, 2);
  const auto rates = ratesOf(products_, variances_);
  divided.J_errors(2, 0) = std::sqrt(share_ * rates(1)) * turn;
  divided.J_errors(2, 1) = std::sqrt(share_ * rates(0)) * motion.increment.x();
  const double missed_turn = std::max(usual_turn_ - std::abs(turn), 0.0);
  usual_turn_ += kShareOfNew * (std::abs(turn) - usual_turn_);
  const Eigen::Vector3d left(1.0, 1.0, std::sqrt(1.0 - share_));
  divided.random.covariance = left.asDiagonal() * motion.covariance * left.asDiagonal();
  divided.random.covariance(2, 2) += (1.0 - share_) * rates(1) * missed_turn;
  return divided;
}

}  // namespace slam::mono_ekf
