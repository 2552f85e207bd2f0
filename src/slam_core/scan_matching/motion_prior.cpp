// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/motion_prior.hpp"

#include <Eigen/LU>
#include <cmath>

namespace slam::scan_matching {
namespace {

constexpr double kLeastSlip = 0.02;   // [m], [rad]
constexpr double kSlipOfOwn = 0.2;    // of a way to the way, of a turn to the turn
constexpr double kSlipOfOther = 0.1;  // of a turn to the way [m/rad], of a way to the turn [rad/m]

Eigen::Vector3d slipOf(const Pose2& increment) {
  const double way = increment.position().norm(), turn = std::abs(increment.theta());
  const double position = kLeastSlip + kSlipOfOwn * way + kSlipOfOther * turn;
  return {position, position, kLeastSlip + kSlipOfOwn * turn + kSlipOfOther * way};
}

}  // namespace

PosePrior priorAfter(const Pose2& before, const Eigen::Matrix3d& covariance, const Pose2& increment,
                     const Eigen::Matrix3d& noise) {
  Eigen::Matrix3d J_before, J_u, Q = noise;
  PosePrior prior{before.compose(increment, &J_before, &J_u)};
  Q.diagonal() += slipOf(increment).cwiseAbs2();
  const Eigen::Matrix3d P =
      J_before * covariance * J_before.transpose() + J_u * Q * J_u.transpose();
  prior.information = P.inverse();
  return prior;
}

}  // namespace slam::scan_matching
