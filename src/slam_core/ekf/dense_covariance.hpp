// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/ekf/innovation.hpp"
#include "slam_core/models/calibration.hpp"

namespace slam::ekf {

/// The covariance of what an observation depends on: robot, heading of the reference, landmark.
using ObservedCovariance = Eigen::Matrix<double, 6, 6>;

/// The joint covariance P of (robot, reference pose, landmark 0, landmark 1, ...) of the
/// neighbourhood, size 6 + 2 N. Where parameters are calibrated, they take the place of the first
/// landmarks. Only the lower triangle is kept up to date, which halves the work
/// of an update; storage doubles when it is full, so that growing by a landmark does not copy.
class DenseCovariance {
 public:
  using Matrix23 = Eigen::Matrix<double, 2, 3>;

  static constexpr Eigen::Index kReferenceRow = 3, kHeadingRow = 5, kHeadSize = 6;
  static constexpr Eigen::Index kParameterRow = kHeadSize;  ///< of the first calibrated parameter
  static Eigen::Index row(Eigen::Index slot) { return kHeadSize + 2 * slot; }

  /// There are no landmarks, and the reference is a copy of the robot.
  explicit DenseCovariance(const Eigen::Matrix3d& robot = Eigen::Matrix3d::Identity());
  /// @param joint a full symmetric matrix of size 6 + 2 N.
  explicit DenseCovariance(const Eigen::MatrixXd& joint);

  Eigen::Index size() const { return size_; }

  Eigen::Matrix3d robot() const;
  double operator()(Eigen::Index row, Eigen::Index column) const {
    return row >= column ? P_(row, column) : P_(column, row);
  }

  /// P <- F P F^T + Q, where F differs from the identity in the robot's rows only: in its block,
  /// and by A where the motion depends on the calibrated parameters.
  void predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q,
               const CalibrationJacobian<3>& A = {});
  /// P H^T, one pair of columns for each innovation.
  Eigen::MatrixXd timesTransposed(const std::vector<Innovation>& innovations) const;
  /// P <- P - W W^T
  void subtractOuterProduct(const Eigen::MatrixXd& W);
  /// The same for the rows and columns of the robot only: a fixed map is considered, not changed
  /// (Schmidt-Kalman update).
  void subtractOuterProductOfRobot(const Eigen::MatrixXd& W);
  /// Appends m = g(robot, z): J = dg/drobot, R the noise of z mapped into the plane.
  void append(const Matrix23& J_m_robot, const Eigen::Matrix2d& R);
  /// Appends a landmark by its covariance with all there is, a column each, and with itself.
  void appendJoint(const Eigen::Ref<const Eigen::Matrix2Xd>& cross, const Eigen::Matrix2d& itself);

  template <class Archive>
  void persist(Archive& archive) {
    archive(P_, size_);
  }

 private:
  static constexpr Eigen::Index kRobotSize = 3;
  /// The rows of so many calibrated parameters, complete.
  Eigen::MatrixXd parameterRows(Eigen::Index count) const;
  void reserve(Eigen::Index size);

  Eigen::MatrixXd P_;  ///< capacity x capacity, lower triangle
  Eigen::Index size_ = kHeadSize;
};

/// The robot's error e_xy becomes e_xy + c e_theta.
void transportRobot(const Eigen::Vector2d& c, DenseCovariance& P);
/// What observations of two landmarks depend on, a row for each of the first's and a column for
/// each of the second's.
ObservedCovariance observedOf(const DenseCovariance& P, Eigen::Index first_slot,
                              Eigen::Index second_slot);
Eigen::Matrix2d landmarkOf(const DenseCovariance& P, Eigen::Index slot);
/// The variance of the robot's heading relative to the reference's [rad^2].
double relativeHeadingVariance(const DenseCovariance& P);

}  // namespace slam::ekf
