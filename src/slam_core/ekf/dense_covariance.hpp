// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/ekf/innovation.hpp"

namespace slam::ekf {

/// The joint covariance P of (robot, landmark 0, landmark 1, ...), size 3 + 2 N. Only the lower
/// triangle is kept up to date, which halves the work of an update; storage doubles when it is
/// full, so that growing by a landmark does not copy.
class DenseCovariance {
 public:
  using Matrix23 = Eigen::Matrix<double, 2, 3>;

  explicit DenseCovariance(const Eigen::Matrix3d& robot = Eigen::Matrix3d::Identity());
  /// From a full symmetric matrix of size 3 + 2 N.
  explicit DenseCovariance(const Eigen::MatrixXd& joint);

  Eigen::Index size() const { return size_; }

  Eigen::Matrix3d robot() const;
  Eigen::Matrix2d landmark(Eigen::Index i) const;
  Matrix23 landmarkRobot(Eigen::Index i) const;  ///< the block (landmark i, robot)
  Eigen::MatrixXd joint() const;                 ///< the whole matrix, both triangles

  /// P <- F P F^T + Q, where F differs from the identity in the robot's block only.
  void predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q);
  /// P H^T, one pair of columns for each innovation.
  Eigen::MatrixXd timesTransposed(const std::vector<Innovation>& innovations) const;
  /// P <- P - W W^T
  void subtractOuterProduct(const Eigen::MatrixXd& W);
  /// The same for the rows and columns of the robot only: a fixed map is considered, not changed
  /// (Schmidt-Kalman update).
  void subtractOuterProductOfRobot(const Eigen::MatrixXd& W);
  /// Appends m = g(robot, z): J = dg/drobot, R the noise of z mapped into the plane.
  void append(const Matrix23& J_m_robot, const Eigen::Matrix2d& R);
  /// The robot is drawn anew: its block is replaced, its correlations are removed.
  void resetRobot(const Eigen::Matrix3d& robot);

 private:
  static constexpr Eigen::Index kRobotSize = 3;
  static Eigen::Index row(Eigen::Index landmark) { return kRobotSize + 2 * landmark; }
  void reserve(Eigen::Index size);

  Eigen::MatrixXd P_;  ///< capacity x capacity, lower triangle
  Eigen::Index size_ = kRobotSize;
};

}  // namespace slam::ekf
