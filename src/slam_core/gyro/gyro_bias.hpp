// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam::gyro {

/// A Kalman filter of the gyro's bias, which is what it measures at rest [rad/s]. Wheels show the
/// bias only as far as they are right. So the state has the systematic errors of their heading as
/// well (Borenstein and Feng 1996): a drift on each metre of the way [rad/m], of wheels of unequal
/// size, and a share of each turn, of a wheelbase that is not the true one. On a robot that steers
/// by slipping that share is a third and more, and changes with the ground. All three walk at
/// random.
///
/// Errors of the bias add up coherently, while back-ends take the increments' errors for
/// independent. So the filter keeps the covariance of bias and heading as well (Schmidt's consider
/// filter: the heading is not corrected afterwards), as far as the heading has gone wrong within
/// the last quarter of a minute. Then the variances of increments add up to the true one over half
/// a minute. Over less they are too large, over more too small.
class GyroBias {
 public:
  GyroBias() = default;
  /// @param sigma of the bias before anything is known [rad/s] @param random_walk [rad/s/sqrt(s)]
  GyroBias(double sigma, double random_walk);

  double bias() const { return x_[0]; }         ///< [rad/s]
  double variance() const { return P_(0, 0); }  ///< of it [rad^2/s^2]
  /// @return what the bias' uncertainty adds to the heading's variance within this time [rad^2]
  double headingVariance(double seconds) const;

  /// Time goes on. @param drifts the gyro gave the heading meanwhile
  void predict(double seconds, bool drifts);
  /// The gyro's mean rate while the robot stood [rad/s], with its variance.
  void observeAtRest(double rate, double variance);
  /// The gyro's mean rate less the wheels', at this speed [m/s], with its variance. Nothing is
  /// learnt from a contradiction: wheels that slip show nothing.
  /// @param turn_rate of the robot [rad/s]
  void observeBesideWheels(double excess, double speed, double turn_rate, double variance);
  /// The distance between a rate that was measured at rest and the bias, in standard deviations of
  /// both.
  double deviationOf(double rate, double variance) const;
  bool hasRested() const { return has_rested_; }
  /// The bias is another one than was known.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(x_, P_, P_heading_, has_rested_);
  }

 private:
  void update(const Eigen::RowVector3d& H, double innovation, double R);

  double random_walk_ = 0.0;
  bool has_rested_ = false;                              ///< observeAtRest() was called
  Eigen::Vector3d x_ = Eigen::Vector3d::Zero();          ///< bias, drift, share
  Eigen::Matrix3d P_ = Eigen::Matrix3d::Zero();          ///< of x_
  Eigen::Vector3d P_heading_ = Eigen::Vector3d::Zero();  ///< of x_ and the heading
};

}  // namespace slam::gyro
