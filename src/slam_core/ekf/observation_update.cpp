// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/observation_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "slam_core/ekf/symmetric_update.hpp"

// Symbols: x state, P its covariance, z observation with covariance R, H its Jacobian by robot,
// heading (that of the reference) and landmark, nu innovation with covariance
// S = H P H^T + R = L L^T, y = L^-1 nu the whitened innovation, W = P H^T L^-T, dx = W y the
// correction.

namespace slam::ekf {
namespace {

using Eigen::Index;

/// An observation that is off the linear prediction by less than this share of its sigma, in the
/// mean, is linear.
constexpr double kLinear = 0.01;

Index column(std::size_t match) { return 2 * static_cast<Index>(match); }

}  // namespace

ObservationUpdate::ObservationUpdate(const ObservationModel& model, const EkfState& state,
                                     const Pose2& sensor, const std::vector<Match>& matches,
                                     int linearizations)
    : state_(state), matches_(matches), innovations_(matches.size()), S_diagonal_(matches.size()) {
  gather();
  dx_ = Eigen::VectorXd::Zero(P_.rows());
  const int limit = state.linearization().relinearizes() ? linearizations : 1;
  for (int i = 1; i <= limit; ++i) {
    linearize(model, sensor);
    solve();
    if (!is_solved_ || i == limit || nonlinearity(model, sensor) < kLinear * kLinear) break;
    P_updated_ = P_ - PHt_ * L_.solve(PHt_.transpose());
  }
  if (is_solved_ || limit == 1) return;
  dx_.setZero();  // the iteration diverged: the plain update
  P_updated_.resize(0, 0);
  linearize(model, sensor);
  solve();
}

Eigen::Vector2d ObservationUpdate::innovation(std::size_t match) const {
  return nu_.segment<2>(column(match));
}

void ObservationUpdate::gather() {
  const auto& P = state_.covariance();
  std::vector<Index> rows;
  for (Index row = 0; row < kHead; ++row) rows.push_back(row);
  for (const auto& match : matches_)
    for (Index axis = 0; axis < 2; ++axis) rows.push_back(DenseCovariance::row(match.slot) + axis);
  P_.resize(static_cast<Index>(rows.size()), static_cast<Index>(rows.size()));
  for (Index j = 0; j < P_.cols(); ++j)
    for (Index i = 0; i < P_.rows(); ++i)
      P_(i, j) = P(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
}

Pose2 ObservationUpdate::candidate() const {
  return state_.linearization().moved(state_.robot(), dx_.head<3>());
}

LandmarkPoint ObservationUpdate::candidate(std::size_t match) const {
  return state_.point(matches_[match].slot, dx_.segment<2>(kHead + column(match)),
                      dx_(DenseCovariance::kHeadingRow));
}

void ObservationUpdate::linearize(const ObservationModel& model, const Pose2& sensor) {
  nu_.resize(2 * static_cast<Index>(matches_.size()));
  const Pose2 robot = candidate();
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const auto& [slot, z] = matches_[i];
    innovations_[i] =
        state_.innovation({model, robot, sensor, candidate(i), z}, covarianceAround(i));
    innovations_[i].slot = slot;
    nu_.segment<2>(column(i)) = innovations_[i].nu;
  }
  nu_ += jacobianTimes(dx_);  // the residual of a Gauss-Newton step (Bell and Cathey 1993)
}

ObservedCovariance ObservationUpdate::covarianceAround(std::size_t match) const {
  const auto& P = P_updated_.size() > 0 ? P_updated_ : P_;
  const Index landmark = kHead + column(match);
  const std::array<Index, 6> rows = {0, 1, 2, DenseCovariance::kHeadingRow, landmark, landmark + 1};
  ObservedCovariance observed;
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i)
      observed(static_cast<Index>(i), static_cast<Index>(j)) = P(rows[i], rows[j]);
  return observed;
}

Eigen::VectorXd ObservationUpdate::jacobianTimes(const Eigen::VectorXd& dx) const {
  Eigen::VectorXd result(2 * static_cast<Index>(innovations_.size()));
  for (std::size_t i = 0; i < innovations_.size(); ++i)
    result.segment<2>(column(i)) = innovations_[i].H_robot * dx.head<3>() +
                                   innovations_[i].H_heading * dx(DenseCovariance::kHeadingRow) +
                                   innovations_[i].H_landmark * dx.segment<2>(kHead + column(i));
  return result;
}

void ObservationUpdate::solve() {
  const Index size = nu_.size();
  PHt_.resize(P_.rows(), size);
  for (std::size_t i = 0; i < innovations_.size(); ++i) {
    const auto& h = innovations_[i];
    // lazy: the general product would pack these narrow blocks
    PHt_.middleCols<2>(column(i)) =
        P_.leftCols<3>().lazyProduct(h.H_robot.transpose()) +
        P_.col(DenseCovariance::kHeadingRow).lazyProduct(h.H_heading.transpose()) +
        P_.middleCols<2>(kHead + column(i)).lazyProduct(h.H_landmark.transpose());
  }
  Eigen::MatrixXd S(size, size);  // the lower triangle
  for (std::size_t j = 0; j < innovations_.size(); ++j) {
    const auto of_z = PHt_.middleCols<2>(column(j));
    const Eigen::Matrix<double, 3, 2> robot = of_z.topRows<3>();
    const Eigen::RowVector2d heading = of_z.row(DenseCovariance::kHeadingRow);
    for (std::size_t i = j; i < innovations_.size(); ++i) {
      const auto& h = innovations_[i];
      S.block<2, 2>(column(i), column(j)) = h.H_robot * robot + h.H_heading * heading +
                                            h.H_landmark * of_z.middleRows<2>(kHead + column(i));
    }
    S.block<2, 2>(column(j), column(j)) += innovations_[j].R;
  }
  for (std::size_t i = 0; i < innovations_.size(); ++i)
    S_diagonal_[i] = S.block<2, 2>(column(i), column(i));
  L_.compute(S);
  whitened_ = L_.matrixL().solve(nu_);
  is_solved_ = L_.info() == Eigen::Success && whitened_.allFinite();
  if (is_solved_) dx_ = PHt_ * L_.matrixU().solve(whitened_);
}

/// The mean squared distance between the observation predicted at the corrected state and the one
/// that the linearisation predicted, in sigmas.
double ObservationUpdate::nonlinearity(const ObservationModel& model, const Pose2& sensor) const {
  const Eigen::VectorXd foretold = nu_ - jacobianTimes(dx_);
  const Pose2 robot = candidate();
  double sum = 0.0;
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const auto point = candidate(i);
    const auto& of_kind = point.modelOr(model);
    const Eigen::Vector2d nu =
        of_kind.innovation(matches_[i].z.vector(), of_kind.predict(robot, sensor, point.now));
    const Eigen::Vector2d off = nu - foretold.segment<2>(column(i));
    sum += off.cwiseAbs2().cwiseQuotient(matches_[i].z.covariance.diagonal()).sum();
  }
  return sum / static_cast<double>(foretold.size());
}

double ObservationUpdate::logLikelihood() const {
  const double log_root = L_.matrixLLT().diagonal().array().log().sum();
  return -0.5 * (nis() + static_cast<double>(nu_.size()) * std::log(2.0 * M_PI)) - log_root;
}

JointInnovation ObservationUpdate::joint() const {
  const auto count = std::min(matches_.size(), UpdateStatistics::kJoint);
  const Index size = column(count);
  const Eigen::MatrixXd L = L_.matrixLLT().topLeftCorner(size, size).triangularView<Eigen::Lower>();
  JointInnovation joint{nu_.head(size), L * L.transpose(), Eigen::MatrixXd::Zero(size, size),
                        Eigen::MatrixX3d(size, 3)};
  for (std::size_t i = 0; i < count; ++i) {
    joint.R.block<2, 2>(column(i), column(i)) = matches_[i].z.covariance;
    joint.H.middleRows<2>(column(i)) = innovations_[i].H_robot;
  }
  return joint;
}

double ObservationUpdate::referenceEffect() const {
  double largest = 0.0;
  for (const auto& h : innovations_)
    largest = std::max(largest, h.H_heading.cwiseAbs2().cwiseQuotient(h.R.diagonal()).maxCoeff());
  return std::sqrt(largest * std::max(0.0, relativeHeadingVariance(state_.covariance())));
}

Eigen::MatrixXd ObservationUpdate::gain() const {
  Eigen::MatrixXd W = state_.covariance().timesTransposed(innovations_);
  solveTransposedFromRight(L_.matrixLLT(), W);
  return W;
}

}  // namespace slam::ekf
