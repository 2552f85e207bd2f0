// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/dense_covariance.hpp"

#include <algorithm>

#include "slam_core/ekf/symmetric_update.hpp"

namespace slam::ekf {

DenseCovariance::DenseCovariance(const Eigen::Matrix3d& robot)
    : P_(Eigen::MatrixXd::Zero(kRobotSize, kRobotSize)) {
  P_ = robot;
}

DenseCovariance::DenseCovariance(const Eigen::MatrixXd& joint) : P_(joint), size_(joint.rows()) {}

Eigen::Matrix3d DenseCovariance::robot() const {
  return P_.topLeftCorner<3, 3>().selfadjointView<Eigen::Lower>();
}

Eigen::Matrix2d DenseCovariance::landmark(Eigen::Index i) const {
  return P_.block<2, 2>(row(i), row(i)).selfadjointView<Eigen::Lower>();
}

DenseCovariance::Matrix23 DenseCovariance::landmarkRobot(Eigen::Index i) const {
  return P_.block<2, 3>(row(i), 0);
}

Eigen::MatrixXd DenseCovariance::joint() const {
  return P_.topLeftCorner(size_, size_).selfadjointView<Eigen::Lower>();
}

void DenseCovariance::predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q) {
  P_.topLeftCorner<3, 3>() = (F * robot() * F.transpose() + Q).eval();
  auto map_robot = P_.block(kRobotSize, 0, size_ - kRobotSize, kRobotSize);
  map_robot = (map_robot * F.transpose()).eval();
}

Eigen::MatrixXd DenseCovariance::timesTransposed(const std::vector<Innovation>& innovations) const {
  Eigen::MatrixXd PHt(size_, 2 * static_cast<Eigen::Index>(innovations.size()));
  const Eigen::Matrix3d P_rr = robot();
  const Eigen::Index below_robot = size_ - kRobotSize;
  Eigen::Index column = 0;
  for (const auto& innovation : innovations) {
    const Eigen::Index m = row(innovation.landmark), below = size_ - m - 2;
    const auto& H_m = innovation.H_landmark;
    auto out = PHt.middleCols<2>(column);
    out.topRows<3>() = P_rr * innovation.H_robot.transpose();
    out.bottomRows(below_robot) =
        P_.block(kRobotSize, 0, below_robot, kRobotSize) * innovation.H_robot.transpose();
    out.topRows(m) += P_.block(m, 0, 2, m).transpose() * H_m.transpose();
    out.middleRows<2>(m) += landmark(innovation.landmark) * H_m.transpose();
    out.bottomRows(below) += P_.block(m + 2, m, below, 2) * H_m.transpose();
    column += 2;
  }
  return PHt;
}

void DenseCovariance::subtractOuterProduct(const Eigen::MatrixXd& W) {
  subtractOuterProductLower(W, P_.data(), size_, P_.outerStride());
}

void DenseCovariance::subtractOuterProductOfRobot(const Eigen::MatrixXd& W) {
  P_.topLeftCorner(size_, kRobotSize) -= W * W.topRows<3>().transpose();
}

void DenseCovariance::append(const Matrix23& J_m_robot, const Eigen::Matrix2d& R) {
  reserve(size_ + 2);
  P_.block<2, 3>(size_, 0) = J_m_robot * robot();
  P_.block(size_, kRobotSize, 2, size_ - kRobotSize) =
      J_m_robot * P_.block(kRobotSize, 0, size_ - kRobotSize, kRobotSize).transpose();
  P_.block<2, 2>(size_, size_) = J_m_robot * robot() * J_m_robot.transpose() + R;
  size_ += 2;
}

void DenseCovariance::resetRobot(const Eigen::Matrix3d& robot) {
  P_.topLeftCorner<3, 3>() = robot;
  P_.block(kRobotSize, 0, size_ - kRobotSize, kRobotSize).setZero();
}

void DenseCovariance::reserve(Eigen::Index size) {
  if (size <= P_.rows()) return;
  constexpr Eigen::Index kFirstCapacity = 67;  // 32 landmarks
  const Eigen::Index capacity = std::max({size, 2 * P_.rows(), kFirstCapacity});
  Eigen::MatrixXd grown = Eigen::MatrixXd::Zero(capacity, capacity);
  grown.topLeftCorner(size_, size_) = P_.topLeftCorner(size_, size_);
  P_.swap(grown);
}

}  // namespace slam::ekf
