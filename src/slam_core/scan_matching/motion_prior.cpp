// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/motion_prior.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slam::scan_matching {
namespace {

constexpr double kLeastSlip = 0.02;   // [m], [rad]
constexpr double kSlipOfOwn = 0.2;    // of a way to the way, of a turn to the turn
constexpr double kSlipOfOther = 0.1;  // of a turn to the way [m/rad], of a way to the turn [rad/m]

constexpr double kScansMeant = 100.0;      // that what is learnt is the mean of, about
constexpr double kLeastVariance = 0.0025;  // relative to that of the beginning

/// Standard deviations, where nothing has been learnt.
Eigen::Vector3d slipOf(const Pose2& increment) {
  const double way = increment.position().norm(), turn = std::abs(increment.theta());
  const double position = kLeastSlip + kSlipOfOwn * way + kSlipOfOther * turn;
  return {position, position, kLeastSlip + kSlipOfOwn * turn + kSlipOfOther * way};
}

void learnVariance(double& variance, double sample, double share) {
  variance = std::max(kLeastVariance, variance + share / kScansMeant * (sample - variance));
}

}  // namespace

Eigen::Matrix3d SlipEstimate::covarianceOf(const Pose2& increment) const {
  const Eigen::Array3d variances(position_, position_, heading_);
  return (variances * slipOf(increment).array().square()).matrix().asDiagonal();
}

/// A slip counts as one of the beginning's size at most: it says little of the usual.
void SlipEstimate::learn(const Pose2& increment, const Pose2& error,
                         const Eigen::Vector3d& shares) {
  const Eigen::Array3d samples =
      (error.vector().array() / slipOf(increment).array()).square().min(1.0);
  learnVariance(position_, samples.x(), shares.x());
  learnVariance(position_, samples.y(), shares.y());
  learnVariance(heading_, samples.z(), shares.z());
}

PosePrior priorAfter(const Pose2& before, const Eigen::Matrix3d& covariance, const Pose2& increment,
                     const Eigen::Matrix3d& noise) {
  Eigen::Matrix3d J_before, J_u;
  PosePrior prior{before.compose(increment, &J_before, &J_u)};
  const Eigen::Matrix3d P =
      J_before * covariance * J_before.transpose() + J_u * noise * J_u.transpose();
  prior.information = P.inverse();
  return prior;
}

}  // namespace slam::scan_matching
