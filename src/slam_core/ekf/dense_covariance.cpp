// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/dense_covariance.hpp"

#include <algorithm>
#include <array>

#include "slam_core/ekf/symmetric_update.hpp"

namespace slam::ekf {

DenseCovariance::DenseCovariance(const Eigen::Matrix3d& robot)
    : P_(robot.replicate<2, 2>()), size_(kHeadSize) {}

DenseCovariance::DenseCovariance(const Eigen::MatrixXd& joint) : P_(joint), size_(joint.rows()) {}

Eigen::Matrix3d DenseCovariance::robot() const {
  return P_.topLeftCorner<3, 3>().selfadjointView<Eigen::Lower>();
}

void DenseCovariance::predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q,
                              const CalibrationJacobian<3>& A) {
  const Eigen::MatrixXd by_parameters = A * parameterRows(A.cols());  // A P_c,all
  P_.topLeftCorner<3, 3>() = (F * robot() * F.transpose() + Q).eval();
  auto others_robot = P_.block(kRobotSize, 0, size_ - kRobotSize, kRobotSize);
  others_robot = (others_robot * F.transpose()).eval();
  if (A.cols() == 0) return;
  const Eigen::Matrix3d cross = by_parameters.leftCols<3>() * F.transpose();
  P_.topLeftCorner<3, 3>() +=
      cross + cross.transpose() + by_parameters.middleCols(kParameterRow, A.cols()) * A.transpose();
  others_robot += by_parameters.rightCols(size_ - kRobotSize).transpose();
}

Eigen::MatrixXd DenseCovariance::parameterRows(Eigen::Index count) const {
  Eigen::MatrixXd rows(count, size_);
  const Eigen::Index below = size_ - kParameterRow - count;
  if (count == 0) return rows;
  rows.leftCols(kParameterRow) = P_.block(kParameterRow, 0, count, kParameterRow);
  rows.middleCols(kParameterRow, count) =
      P_.block(kParameterRow, kParameterRow, count, count).selfadjointView<Eigen::Lower>();
  rows.rightCols(below) = P_.block(kParameterRow + count, kParameterRow, below, count).transpose();
  return rows;
}

Eigen::MatrixXd DenseCovariance::timesTransposed(const std::vector<Innovation>& innovations) const {
  Eigen::MatrixXd PHt(size_, 2 * static_cast<Eigen::Index>(innovations.size()));
  const Eigen::Matrix3d P_rr = robot();
  const Eigen::Index below_robot = size_ - kRobotSize, below_heading = size_ - kHeadingRow;
  Eigen::Index column = 0;
  for (const auto& innovation : innovations) {
    const Eigen::Index m = row(innovation.slot), below = size_ - m - 2;
    const auto& H_m = innovation.H_landmark;
    const auto& H_h = innovation.H_heading;
    auto out = PHt.middleCols<2>(column);
    out.topRows<3>() = P_rr * innovation.H_robot.transpose();
    // lazy: the general product would pack these narrow blocks
    out.bottomRows(below_robot) =
        P_.block<Eigen::Dynamic, kRobotSize>(kRobotSize, 0, below_robot, kRobotSize)
            .lazyProduct(innovation.H_robot.transpose());
    out.topRows(kHeadingRow) += P_.row(kHeadingRow).head(kHeadingRow).transpose() * H_h.transpose();
    out.bottomRows(below_heading) +=
        P_.col(kHeadingRow).segment(kHeadingRow, below_heading) * H_h.transpose();
    out.topRows(m) +=
        P_.block<2, Eigen::Dynamic>(m, 0, 2, m).transpose().lazyProduct(H_m.transpose());
    out.middleRows<2>(m) += landmarkOf(*this, innovation.slot) * H_m.transpose();
    out.bottomRows(below) +=
        P_.block<Eigen::Dynamic, 2>(m + 2, m, below, 2).lazyProduct(H_m.transpose());
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
  Eigen::Matrix2Xd cross(2, size_);
  cross.leftCols<3>() = J_m_robot * robot();
  cross.rightCols(size_ - kRobotSize) =
      J_m_robot * P_.block(kRobotSize, 0, size_ - kRobotSize, kRobotSize).transpose();
  appendJoint(cross, J_m_robot * robot() * J_m_robot.transpose() + R);
}

void DenseCovariance::appendJoint(const Eigen::Ref<const Eigen::Matrix2Xd>& cross,
                                  const Eigen::Matrix2d& itself) {
  reserve(size_ + 2);
  P_.block(size_, 0, 2, size_) = cross;
  P_.block<2, 2>(size_, size_) = itself;
  size_ += 2;
}

void DenseCovariance::reserve(Eigen::Index size) {
  if (size <= P_.rows()) return;
  constexpr Eigen::Index kFirstCapacity = 70;  // 32 landmarks
  const Eigen::Index capacity = std::max({size, 2 * P_.rows(), kFirstCapacity});
  Eigen::MatrixXd grown = Eigen::MatrixXd::Zero(capacity, capacity);
  grown.topLeftCorner(size_, size_) = P_.topLeftCorner(size_, size_);
  P_.swap(grown);
}

void transportRobot(const Eigen::Vector2d& c, DenseCovariance& P) {
  Eigen::Matrix3d T = Eigen::Matrix3d::Identity();
  T.topRightCorner<2, 1>() = c;
  P.predict(T, Eigen::Matrix3d::Zero());
}

ObservedCovariance observedOf(const DenseCovariance& P, Eigen::Index first_slot,
                              Eigen::Index second_slot) {
  const auto rowsOf = [](Eigen::Index slot) {
    const auto landmark = DenseCovariance::row(slot);
    return std::array<Eigen::Index, 6>{0,        1,           2, DenseCovariance::kHeadingRow,
                                       landmark, landmark + 1};
  };
  const auto first = rowsOf(first_slot), second = rowsOf(second_slot);
  ObservedCovariance observed;
  for (std::size_t j = 0; j < second.size(); ++j)
    for (std::size_t i = 0; i < first.size(); ++i)
      observed(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = P(first[i], second[j]);
  return observed;
}

Eigen::Matrix2d landmarkOf(const DenseCovariance& P, Eigen::Index slot) {
  const Eigen::Index x = DenseCovariance::row(slot), y = x + 1;
  return (Eigen::Matrix2d() << P(x, x), P(x, y), P(y, x), P(y, y)).finished();
}

double relativeHeadingVariance(const DenseCovariance& P) {
  constexpr Eigen::Index kRobot = 2, kReference = DenseCovariance::kHeadingRow;
  return P(kRobot, kRobot) + P(kReference, kReference) - 2.0 * P(kReference, kRobot);
}

}  // namespace slam::ekf
