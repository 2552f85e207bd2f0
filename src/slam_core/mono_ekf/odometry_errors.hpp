// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/models/motion.hpp"

namespace slam::mono_ekf {

/// The errors of an odometry's heading that are the same on the whole way, as of wheels of slightly
/// wrong sizes: one that grows with each turn, and one that grows with the way (Borenstein and Feng
/// 1996). In standard deviations, so that each is a standard normal number before the drive. The
/// error of the way's length is not among them: one camera does not show it, and a filter that
/// estimates it takes what linearisation leaves for knowledge of it.
constexpr int kSystematicErrors = 2;

/// A motion with its noise divided into what is random and what is systematic.
struct DividedMotion {
  Motion random;  ///< with the covariance of its random errors alone
  /// The increment (x, y, theta) in the systematic errors [m, m, rad].
  Eigen::Matrix<double, 3, kSystematicErrors> J_errors =
      Eigen::Matrix<double, 3, kSystematicErrors>::Zero();
};

/// Divides the noise that an odometry claims for its heading. The claim is taken to hold for pieces
/// of the way of a metre, or turns of a radian; there systematic errors make a share of its
/// variance. On longer ways they grow with the way, the random ones with its root.
///
/// The claim is a variance for each motion, which is made of one for each metre and one for each
/// radian (Thrun, Burgard and Fox 2005, 5.4). Both are found by least squares over all motions so
/// far, which finds them exactly where the odometry made them so.
///
/// A claim goes by the turn as measured: where a wheel errs against a turn, the motion seems to
/// turn little and claims little. So a motion's turn counts as at least the mean of those before
/// it.
class OdometryErrors {
 public:
  OdometryErrors() = default;
  /// @param share of the heading's variance that is systematic, below 1
  explicit OdometryErrors(double share) : share_(share) {}

  /// To be called with each motion in turn.
  DividedMotion divide(const Motion& motion);

  template <class Archive>
  void persist(Archive& archive) {
    archive(products_, variances_, usual_turn_);
  }

 private:
  double share_ = 0.0;
  /// Sums over the motions of the products of (way, turn) with one another and with the variance.
  Eigen::Matrix2d products_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d variances_ = Eigen::Vector2d::Zero();
  double usual_turn_ = 0.0;  ///< of a motion, whatever the direction, over the last ten [rad]
};

}  // namespace slam::mono_ekf
