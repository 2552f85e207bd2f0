// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_bias.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/gyro/squared.hpp"

namespace slam::gyro {
namespace {

/// The sigmas suit wheels of which nothing is known, as of a robot that steers by slipping.
constexpr double kDriftSigma = 0.1, kDriftWalk = 0.01;  // [rad/m], [rad/m/sqrt(s)]
constexpr double kShareSigma = 0.5, kShareWalk = 0.05;  // [1], [1/sqrt(s)]
constexpr double kMemory = 15.0;                        // of the heading's error [s]
constexpr double kGate = 4.0;                           // [standard deviations]

}  // namespace

GyroBias::GyroBias(double sigma, double random_walk) : random_walk_(random_walk) {
  P_.diagonal() << squared(sigma), squared(kDriftSigma), squared(kShareSigma);
}

double GyroBias::headingVariance(double seconds) const {
  return squared(seconds) * P_(0, 0) + 2.0 * seconds * std::max(0.0, P_heading_[0]);
}

void GyroBias::predict(double seconds, bool drifts) {
  const double kept = std::exp(-seconds / kMemory);
  P_heading_ *= kept;
  if (drifts) P_heading_ += kMemory * (1.0 - kept) * P_.col(0);
  P_.diagonal() +=
      seconds * Eigen::Vector3d(squared(random_walk_), squared(kDriftWalk), squared(kShareWalk));
}

void GyroBias::observeAtRest(double rate, double variance) {
  update({1.0, 0.0, 0.0}, rate - x_[0], variance);
  has_rested_ = true;
}

void GyroBias::observeBesideWheels(double excess, double speed, double turn_rate, double variance) {
  const Eigen::RowVector3d H(1.0, -speed, -turn_rate);
  const double innovation = excess - H.dot(x_);
  const double S = H * P_ * H.transpose() + variance;
  if (squared(innovation) <= squared(kGate) * S) update(H, innovation, variance);
}

double GyroBias::deviationOf(double rate, double variance) const {
  return std::abs(rate - x_[0]) / std::sqrt(P_(0, 0) + variance);
}

void GyroBias::forget() {
  x_[0] = 0.0;
  P_.row(0).setZero();
  P_.col(0).setZero();
  P_(0, 0) = 1.0;  // any gyro's bias is smaller
  P_heading_[0] = 0.0;
}

void GyroBias::update(const Eigen::RowVector3d& H, double innovation, double R) {
  const double S = H * P_ * H.transpose() + R;
  const Eigen::Vector3d K = P_ * H.transpose() / S;
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - K * H;
  x_ += K * innovation;
  P_ = symmetric(rest * P_ * rest.transpose() + R * K * K.transpose());
  P_heading_ = rest * P_heading_;
}

}  // namespace slam::gyro
