// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/neighbourhood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "slam_core/ekf/index.hpp"
#include "slam_core/ekf/symmetric_update.hpp"

namespace slam::ekf {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kHeading = DenseCovariance::kHeadingRow;

/// The pivot of a variable that is fully determined by those before it would be 0, and the division
/// by it fail.
double pivotRoot(double pivot, double variance) {
  constexpr double kSmallestShare = 1e-15, kSmallest = 1e-300;
  return std::sqrt(std::max({pivot, kSmallestShare * variance, kSmallest}));
}

}  // namespace

Neighbourhood::Neighbourhood(const MatrixXd& joint)
    : prior_(joint), slots_(at((joint.rows() - kPoseSize) / 2), -1) {
  begin();
}

Neighbourhood::Neighbourhood(const Eigen::Matrix3d& robot,
                             const std::vector<Eigen::Matrix2d>& landmarks)
    : prior_(robot), slots_(landmarks.size(), -1) {
  prior_.grow(priorRow(this->landmarks()));
  for (Index i = 0; i < this->landmarks(); ++i)
    for (Index column = 0; column < 2; ++column)
      for (Index row = column; row < 2; ++row)
        prior_.at(priorRow(i) + row, priorRow(i) + column) = landmarks[at(i)](row, column);
  begin();
}

void Neighbourhood::begin() {
  Eigen::Matrix3d robot;
  for (Index row = 0; row < kPoseSize; ++row)
    for (Index column = 0; column < kPoseSize; ++column) robot(row, column) = prior_(row, column);
  local_ = DenseCovariance(robot);
  correction_ = Eigen::VectorXd::Zero(local_.size());
  for (const auto landmark : taken_) slots_[at(landmark)] = -1;
  taken_.clear();
  is_fresh_ = true;
  is_updated_ = false;
  prior_rows_ = {0, 1, 2};
  local_rows_ = {3, 4, 5};
  factored_ = 0;
  known_ = landmarks();
}

void Neighbourhood::take(Index landmark) {
  const Index n = local_.size();
  const Index first = priorRow(landmark);
  const MatrixXd prior = priorOf({landmark});
  Eigen::Matrix2d itself;
  itself << prior_(first, first), prior_(first, first + 1), prior_(first + 1, first),
      prior_(first + 1, first + 1);
  Eigen::Matrix2Xd cross = Eigen::Matrix2Xd::Zero(2, n);
  Eigen::Vector2d correction = Eigen::Vector2d::Zero();
  // Landmarks may have been appended since, although the robot stands where it stood.
  if (!is_fresh_ || known_ < landmarks()) {
    const MatrixXd gain = solvePrior(prior);
    cross = (localColumns() * gain).transpose();
    for (Index i = 0; i < gain.rows(); ++i)
      correction += gain.row(i).transpose() * correction_(local_rows_[at(i)]);
    if (is_updated_)
      for (Index i = 0; i < gain.rows(); ++i)
        itself += (cross.col(local_rows_[at(i)]) - prior.row(i).transpose()) * gain.row(i);
  }
  if (!is_updated_)  // as it stands, to the bit
    for (Index i = 0; i < prior.rows(); ++i) cross.col(local_rows_[at(i)]) = prior.row(i);
  if (is_fresh_) cross.leftCols<3>() = cross.middleCols<3>(DenseCovariance::kReferenceRow);

  for (Index axis = 0; axis < 2; ++axis) {
    prior_rows_.push_back(first + axis);
    local_rows_.push_back(n + axis);
  }
  slots_[at(landmark)] = size();
  taken_.push_back(landmark);
  local_.appendJoint(cross, itself);
  correction_.conservativeResize(n + 2);
  correction_.tail<2>() = correction;
}

void Neighbourhood::append(const DenseCovariance::Matrix23& J_m_robot, const Eigen::Matrix2d& R) {
  local_.append(J_m_robot, R);
  correction_.conservativeResize(local_.size());
  correction_.tail<2>().setZero();
  taken_.push_back(landmarks());
  slots_.push_back(size() - 1);
}

void Neighbourhood::predict(const Eigen::Matrix3d& F, const Eigen::Matrix3d& Q,
                            const CalibrationJacobian<3>& A) {
  local_.predict(F, Q, A);
  is_fresh_ = false;
}

void Neighbourhood::update(const MatrixXd& W, const Eigen::VectorXd& dx) {
  local_.subtractOuterProduct(W);
  correction_ += dx;
  correction_.head<3>().setZero();
  is_updated_ = true;
  is_fresh_ = false;
}

void Neighbourhood::updateRobot(const MatrixXd& W) {
  local_.subtractOuterProductOfRobot(W);
  is_fresh_ = false;
}

void Neighbourhood::resetRobot(const Eigen::Matrix3d& robot) {
  for (Index row = 0; row < prior_.size(); ++row)
    for (Index column = 0; column < std::min(row + 1, kPoseSize); ++column)
      prior_.at(row, column) = row < kPoseSize ? robot(row, column) : 0.0;
  begin();
}

void Neighbourhood::replace(Index landmark, const DenseCovariance::Matrix23& J_m_robot,
                            const Eigen::Matrix2d& R) {
  const Index first = priorRow(landmark);
  const Eigen::Matrix3d robot = local_.robot();
  const Eigen::Matrix2d itself = J_m_robot * robot * J_m_robot.transpose() + R;
  for (Index other = 0; other < prior_.size(); ++other) {
    if (other == first || other == first + 1) continue;
    const Eigen::Vector3d of_robot(prior_(0, other), prior_(1, other), prior_(2, other));
    const Eigen::Vector2d cross = J_m_robot * of_robot;
    for (Index axis = 0; axis < 2; ++axis)
      prior_.at(std::max(first + axis, other), std::min(first + axis, other)) = cross(axis);
  }
  for (Index axis = 0; axis < 2; ++axis)
    for (Index other = 0; other <= axis; ++other)
      prior_.at(first + axis, first + other) = itself(axis, other);
  begin();
}

std::vector<Index> Neighbourhood::rest() const {
  std::vector<Index> rest;
  for (Index landmark = 0; landmark < landmarks(); ++landmark)
    if (slot(landmark) < 0) rest.push_back(landmark);
  return rest;
}

MatrixXd Neighbourhood::priorOf(const std::vector<Index>& landmarks) const {
  MatrixXd P(static_cast<Index>(prior_rows_.size()), 2 * static_cast<Index>(landmarks.size()));
  for (Index column = 0; column < P.cols(); ++column) {
    const Index of_landmark = priorRow(landmarks[at(column / 2)]) + column % 2;
    for (Index row = 0; row < P.rows(); ++row)
      P(row, column) = prior_(prior_rows_[at(row)], of_landmark);
  }
  return P;
}

MatrixXd Neighbourhood::localColumns() const {
  MatrixXd columns(local_.size(), static_cast<Index>(local_rows_.size()));
  for (Index column = 0; column < columns.cols(); ++column)
    for (Index row = 0; row < columns.rows(); ++row)
      columns(row, column) = local_(row, local_rows_[at(column)]);
  return columns;
}

void Neighbourhood::extendFactor() const {
  const Index size = static_cast<Index>(prior_rows_.size());
  if (factored_ == size) return;
  if (L_.rows() < size) {
    MatrixXd grown = MatrixXd::Zero(2 * size, 2 * size);
    grown.topLeftCorner(factored_, factored_) = L_.topLeftCorner(factored_, factored_);
    L_.swap(grown);
  }
  for (; factored_ < size; ++factored_) {
    const Index n = factored_, prior_row = prior_rows_[at(n)];
    Eigen::VectorXd l(n);
    for (Index i = 0; i < n; ++i) l(i) = prior_(prior_rows_[at(i)], prior_row);
    L_.topLeftCorner(n, n).triangularView<Eigen::Lower>().solveInPlace(l);
    const double variance = prior_(prior_row, prior_row);
    L_.row(n).head(n) = l.transpose();
    L_(n, n) = pivotRoot(variance - l.squaredNorm(), variance);
  }
}

MatrixXd Neighbourhood::timesFactorInverse(MatrixXd left) const {
  extendFactor();
  solveTransposedFromRight(L_.topLeftCorner(factored_, factored_), left);
  return left;
}

/// P_aa0^-1 right
MatrixXd Neighbourhood::solvePrior(MatrixXd right) const {
  extendFactor();
  const auto L = L_.topLeftCorner(factored_, factored_).triangularView<Eigen::Lower>();
  L.solveInPlace(right);
  L.transpose().solveInPlace(right);
  return right;
}

Neighbourhood::Whitened Neighbourhood::whitened() const {
  Whitened whitened;
  whitened.cross = timesFactorInverse(localColumns());
  const Index size = whitened.cross.cols();
  MatrixXd of_taken(size, size);
  for (Index i = 0; i < size; ++i)
    of_taken.col(i) = whitened.cross.row(local_rows_[at(i)]).transpose();
  of_taken = timesFactorInverse(std::move(of_taken));
  whitened.gain = MatrixXd::Identity(size, size) - 0.5 * (of_taken + of_taken.transpose());
  return whitened;
}

Eigen::Matrix2Xd Neighbourhood::allCorrections() const {
  Eigen::Matrix2Xd corrections = Eigen::Matrix2Xd::Zero(2, landmarks());
  for (Index i = 0; i < size(); ++i)
    corrections.col(taken_[at(i)]) = correction_.segment<2>(DenseCovariance::row(i));
  const auto others = rest();
  if (others.empty() || !is_updated_) return corrections;
  Eigen::VectorXd of_taken(static_cast<Index>(local_rows_.size()));
  for (Index i = 0; i < of_taken.size(); ++i) of_taken(i) = correction_(local_rows_[at(i)]);
  const MatrixXd weights = solvePrior(of_taken);
  const Eigen::VectorXd of_rest = priorOf(others).transpose() * weights;
  for (Index i = 0; i < static_cast<Index>(others.size()); ++i)
    corrections.col(others[at(i)]) = of_rest.segment<2>(2 * i);
  return corrections;
}

MatrixXd Neighbourhood::whitenedPrior(const std::vector<Index>& landmarks) const {
  return timesFactorInverse(priorOf(landmarks).transpose());
}

std::vector<Eigen::Matrix2d> Neighbourhood::marginals(const Eigen::Matrix2Xd& c) const {
  std::vector<Eigen::Matrix2d> marginals(at(landmarks()));
  const double variance = local_(kHeading, kHeading);
  const auto put = [&](Index landmark, const Eigen::Matrix2d& P, const Eigen::Vector2d& heading) {
    const auto& of = c.col(landmark);
    const Eigen::Matrix2d cross = (heading + 0.5 * variance * of) * of.transpose();
    marginals[at(landmark)] = of.isZero(0.0) ? P : Eigen::Matrix2d(P + cross + cross.transpose());
  };
  for (Index i = 0; i < size(); ++i) {
    const Index row = DenseCovariance::row(i);
    put(taken_[at(i)], landmarkOf(local_, i), {local_(row, kHeading), local_(row + 1, kHeading)});
  }
  const auto others = rest();
  MatrixXd W, change;
  Eigen::VectorXd heading = Eigen::VectorXd::Zero(2 * static_cast<Index>(others.size()));
  if (is_updated_ && !others.empty()) {
    const auto taken = whitened();
    W = whitenedPrior(others);
    change = timesTransposed(W, taken.gain);
    heading = W * taken.cross.row(kHeading).transpose();
  }
  for (Index i = 0; i < static_cast<Index>(others.size()); ++i) {
    const Index row = priorRow(others[at(i)]);
    Eigen::Matrix2d P;
    P << prior_(row, row), prior_(row, row + 1), prior_(row + 1, row), prior_(row + 1, row + 1);
    if (W.size() > 0) P -= W.middleRows<2>(2 * i) * change.middleRows<2>(2 * i).transpose();
    put(others[at(i)], 0.5 * (P + P.transpose()), heading.segment<2>(2 * i));
  }
  return marginals;
}

Eigen::Matrix2Xd Neighbourhood::varianceBounds(const Eigen::Matrix2Xd& c) const {
  Eigen::Matrix2Xd bounds(2, landmarks());
  const double heading_sigma = std::sqrt(local_(kHeading, kHeading));
  for (Index landmark = 0; landmark < landmarks(); ++landmark)
    for (Index axis = 0; axis < 2; ++axis) {
      const Index i = slot(landmark) < 0 ? priorRow(landmark) + axis
                                         : DenseCovariance::row(slot(landmark)) + axis;
      const double variance = slot(landmark) < 0 ? prior_(i, i) : local_(i, i);
      const double sigma = std::sqrt(variance) + std::abs(c(axis, landmark)) * heading_sigma;
      bounds(axis, landmark) = sigma * sigma;
    }
  return bounds;
}

void Neighbourhood::renew(const Eigen::Matrix2Xd& c) {
  const auto others = rest();
  const bool is_same = is_fresh_ && !is_updated_ && c.isZero(0.0) && known_ == landmarks();
  prior_.grow(priorRow(landmarks()));
  if (!others.empty() && !is_same) updateRest(others, c);
  writeTaken(c);
  begin();
}

/// Writes the blocks of the landmarks that were not taken, and their cross-covariances with the
/// robot and the taken landmarks.
void Neighbourhood::updateRest(const std::vector<Index>& rest, const Eigen::Matrix2Xd& c) {
  const auto taken = whitened();
  const MatrixXd W = whitenedPrior(rest);
  const MatrixXd cross = timesTransposed(W, taken.cross);  // P_b,local
  std::vector<Index> rows;
  Eigen::VectorXd carried(W.rows());
  for (Index i = 0; i < W.rows(); ++i) {
    rows.push_back(priorRow(rest[at(i / 2)]) + i % 2);
    carried(i) = c(i % 2, rest[at(i / 2)]);
  }
  if (is_updated_) prior_.subtractProduct(timesTransposed(W, taken.gain), W, rows);
  const double variance = local_(kHeading, kHeading);
  const bool is_carried = !c.isZero(0.0);
  if (is_carried) {
    MatrixXd A(W.rows(), 2), B(W.rows(), 2);
    A << -carried, -cross.col(kHeading) - 0.5 * variance * carried;
    B << -A.col(1), carried;
    prior_.subtractProduct(A, B, rows);
  }

  const auto put = [&](Index local_row, Index row, double of_other) {
    const double heading = local_(kHeading, local_row) + variance * of_other;
    for (Index i = 0; i < W.rows(); ++i)
      prior_.at(std::max(rows[at(i)], row), std::min(rows[at(i)], row)) =
          cross(i, local_row) + carried(i) * heading + cross(i, kHeading) * of_other;
  };
  for (Index row = 0; row < (is_fresh_ ? 0 : kPoseSize); ++row) put(row, row, 0.0);
  for (Index slot = 0; slot < size(); ++slot) {
    const Index landmark = taken_[at(slot)];
    if (!is_updated_ && !is_carried && landmark < known_) continue;  // as it was, to the bit
    for (Index axis = 0; axis < 2; ++axis)
      put(DenseCovariance::row(slot) + axis, priorRow(landmark) + axis, c(axis, landmark));
  }
}

/// Writes the covariance of the robot and the taken landmarks.
void Neighbourhood::writeTaken(const Eigen::Matrix2Xd& c) {
  std::vector<Index> rows = {0, 1, 2}, local_rows = {0, 1, 2};
  std::vector<double> carried = {0.0, 0.0, 0.0};
  for (Index slot = 0; slot < size(); ++slot)
    for (Index axis = 0; axis < 2; ++axis) {
      rows.push_back(priorRow(taken_[at(slot)]) + axis);
      local_rows.push_back(DenseCovariance::row(slot) + axis);
      carried.push_back(c(axis, taken_[at(slot)]));
    }
  const double variance = local_(kHeading, kHeading);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      prior_.at(std::max(rows[i], rows[j]), std::min(rows[i], rows[j])) =
          local_(local_rows[i], local_rows[j]) + carried[i] * local_(kHeading, local_rows[j]) +
          carried[j] * local_(kHeading, local_rows[i]) + variance * carried[i] * carried[j];
}

}  // namespace slam::ekf
