// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/mono_state.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <utility>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/mono_ekf/invariant_step.hpp"
#include "slam_core/mono_ekf/inverse_depth.hpp"

namespace slam::mono_ekf {

namespace {

/// The 1 - 1e-6 quantile of a chi-square distribution with three degrees of freedom.
constexpr double kPoseGate = 30.66;

PixelScore scoreOf(const Eigen::LLT<Eigen::MatrixXd>& cholesky, const Eigen::VectorXd& whitened,
                   double variance) {
  const auto rows = whitened.size();
  const Eigen::MatrixXd S_inverse = cholesky.solve(Eigen::MatrixXd::Identity(rows, rows));
  const Eigen::VectorXd residuals = variance * cholesky.matrixU().solve(whitened);
  const double fit = residuals.squaredNorm() / variance;
  return {0.5 * (fit - variance * S_inverse.trace()),
          0.5 * variance * variance * S_inverse.squaredNorm()};
}

}  // namespace

MonoState::MonoState(const PoseEstimate& robot)
    : mean_(Eigen::VectorXd::Zero(kHead)), covariance_(Eigen::MatrixXd::Identity(kHead, kHead)) {
  mean_.head<kPose>() = robot.pose.vector();
  covariance_.topLeftCorner<kPose, kPose>() = robot.covariance;
}

PoseEstimate MonoState::robot() const {
  return {Pose2::fromVector(mean_.head<kPose>()), covariance_.topLeftCorner<kPose, kPose>()};
}

void MonoState::predict(const DividedMotion& motion) {
  const auto& [random, J_errors] = motion;
  const Eigen::Vector2d errors = mean_.segment<kSystematicErrors>(kPose);
  const auto increment = Pose2::fromVector(random.increment.vector() + J_errors * errors);
  Eigen::Matrix3d J_pose, J_u;
  mean_.head<kPose>() = robot().pose.compose(increment, &J_pose, &J_u).vector();
  Eigen::Matrix<double, kPose, kHead> J;
  J << J_pose, J_u * J_errors;
  const Eigen::Matrix3d P_moved = J * covariance_.topLeftCorner<kHead, kHead>() * J.transpose() +
                                  J_u * random.covariance * J_u.transpose();
  const auto others = mean_.size() - kPose;
  covariance_.topRightCorner(kPose, others) =
      (J * covariance_.topRightCorner(kHead, others)).eval();
  covariance_.topLeftCorner<kPose, kPose>() = 0.5 * (P_moved + P_moved.transpose());
  covariance_.bottomLeftCorner(others, kPose) =
      covariance_.topRightCorner(kPose, others).transpose();
}

void MonoState::place(const PoseEstimate& robot) {
  mean_.head<kPose>() = robot.pose.vector();
  covariance_.topRows<kPose>().setZero();
  covariance_.leftCols<kPose>().setZero();
  covariance_.topLeftCorner<kPose, kPose>() = robot.covariance;
}

Eigen::Matrix2d predictedCovariance(const MonoState& state, int offset,
                                    const Prediction& prediction) {
  const auto& P = state.covariance();
  const auto& H_r = prediction.J_pose;
  const auto& H_f = prediction.J_feature;
  constexpr int kPose = MonoState::kPose;
  const Eigen::Matrix2d cross = H_r * P.block(0, offset, kPose, H_f.cols()) * H_f.transpose();
  return H_r * P.topLeftCorner<kPose, kPose>() * H_r.transpose() + cross + cross.transpose() +
         H_f * P.block(offset, offset, H_f.cols(), H_f.cols()) * H_f.transpose();
}

Eigen::VectorXd stepped(const MonoState& state, const Eigen::VectorXd& step, double s) {
  Eigen::VectorXd mean = state.mean() + step;
  mean(2) = wrapAngle(mean(2));
  const MapStep map{step(2), s};
  mean.head<2>() = stepped(Eigen::Vector2d(state.mean().head<2>()), step.head<2>(), map);
  for (const auto& feature : state.features())
    mean.segment(feature.offset, feature.size()) = stepped(
        feature, coordinatesOf(state, feature), step.segment(feature.offset, feature.size()), map);
  return mean;
}

Eigen::VectorXd meanAfter(const MonoState& state, const Measurement& measurement, double sigma) {
  const int offset = measurement.offset;
  const auto& prediction = measurement.prediction;
  const auto& P = state.covariance();
  const Eigen::Matrix2d S =
      predictedCovariance(state, offset, prediction) + sigma * sigma * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d weighted = S.inverse() * measurement.nu;
  Eigen::VectorXd step =
      P.leftCols<MonoState::kPose>() * (prediction.J_pose.transpose() * weighted);
  step += P.middleCols(offset, prediction.J_feature.cols()) *
          (prediction.J_feature.transpose() * weighted);
  return stepped(state, step, 0.0);
}

MonoState partOf(const MonoState& state, const std::vector<std::size_t>& features) {
  MonoState part(state.robot());
  std::vector<int> rows(MonoState::kHead);
  std::iota(rows.begin(), rows.end(), 0);
  for (const auto which : features) {
    auto& feature = part.features_.emplace_back(state.features_[which]);
    for (int i = 0; i < feature.size(); ++i) rows.push_back(feature.offset + i);
    feature.offset = static_cast<int>(rows.size()) - feature.size();
  }
  const auto size = static_cast<Eigen::Index>(rows.size());
  part.mean_.resize(size);
  part.covariance_.resize(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    part.mean_(j) = state.mean_(rows[std::size_t(j)]);
    for (Eigen::Index i = 0; i < size; ++i)
      part.covariance_(i, j) = state.covariance_(rows[std::size_t(i)], rows[std::size_t(j)]);
  }
  return part;
}

UpdateStatistics MonoState::update(const std::vector<Measurement>& measurements, double sigma) {
  const auto rows = static_cast<Eigen::Index>(2 * measurements.size());
  if (rows == 0) return {};
  std::vector<int> offsets;
  for (const auto& each : measurements) offsets.push_back(each.offset);
  const ScaleError scale(*this, offsets);
  Eigen::MatrixXd of_map(mean_.size(), 2);
  of_map << covariance_.col(2), scale.columnsOf(covariance_);
  Eigen::MatrixXd PHt(mean_.size(), rows), S(rows, rows);
  Eigen::VectorXd nu(rows);
  Eigen::Index row = 0;
  for (const auto& [offset, prediction, residual, J_scale] : measurements) {
    PHt.middleCols<2>(row) = covariance_.leftCols<kPose>() * prediction.J_pose.transpose();
    PHt.middleCols<2>(row) += covariance_.middleCols(offset, prediction.J_feature.cols()) *
                              prediction.J_feature.transpose();
    PHt.middleCols<2>(row) += of_map.col(1) * J_scale.transpose();
    nu.segment<2>(row) = residual;
    row += 2;
  }
  const Eigen::RowVectorXd scale_row = scale.rowsOf(PHt);
  row = 0;
  for (const auto& [offset, prediction, residual, J_scale] : measurements) {
    S.middleRows<2>(row) = prediction.J_pose * PHt.topRows<kPose>();
    S.middleRows<2>(row) +=
        prediction.J_feature * PHt.middleRows(offset, prediction.J_feature.cols());
    S.middleRows<2>(row) += J_scale * scale_row;
    row += 2;
  }
  S.diagonal().array() += sigma * sigma;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(S);
  const Eigen::MatrixXd W = cholesky.matrixL().solve(PHt.transpose());
  const Eigen::VectorXd whitened = cholesky.matrixL().solve(nu);
  const Eigen::VectorXd step = W.transpose() * whitened;
  Eigen::VectorXd mean = stepped(*this, step, scale.of(step));
  if (!isCredible(mean)) return {false, whitened.squaredNorm(), {}};
  of_map.col(0) -= W.transpose() * W.col(2);
  of_map.col(1) -= W.transpose() * scale.columnsOf(W);
  covariance_.selfadjointView<Eigen::Lower>().rankUpdate(W.transpose(), -1.0);
  moveTo(std::move(mean), scale, std::move(of_map));
  covariance_.triangularView<Eigen::StrictlyUpper>() = covariance_.transpose();
  return {true, whitened.squaredNorm(), scoreOf(cholesky, whitened, sigma * sigma)};
}

/// Every update of a consistent filter is, but one in a million.
bool MonoState::isCredible(const Eigen::VectorXd& mean) const {
  Eigen::Vector3d moved = mean.head<kPose>() - mean_.head<kPose>();
  moved(2) = wrapAngle(moved(2));
  const Eigen::Matrix3d P = covariance_.topLeftCorner<kPose, kPose>();
  return mean.allFinite() && moved.dot(P.ldlt().solve(moved)) <= kPoseGate;
}

/// It takes over the mean, and the errors as they are about it in the covariance's lower triangle.
/// @param of_map covariance of all errors with those of the heading and of the scale
void MonoState::moveTo(Eigen::VectorXd mean, const ScaleError& scale, Eigen::MatrixXd of_map) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(mean.size(), 2);
  const Eigen::Vector2d robot = mean.head<2>() - mean_.head<2>();
  J.topRows<2>() << turnedLeft(robot), robot;
  for (const auto& feature : features_) {
    const auto at = feature.offset, size = feature.size();
    const Eigen::VectorXd moved = mean.segment(at, size) - mean_.segment(at, size);
    J.middleRows(at, size) << addedByHeading(moved), addedByScale(feature, moved);
  }
  Eigen::Matrix2d own;
  own << of_map.row(2), scale.rowsOf(of_map);
  of_map += 0.5 * J * own;
  for (int i = 0; i < 2; ++i)
    covariance_.selfadjointView<Eigen::Lower>().rankUpdate(J.col(i), of_map.col(i), 1.0);
  mean_ = std::move(mean);
}

void MonoState::add(const std::vector<Seed>& seeds, double sigma, double sigma_rho) {
  const auto old_size = mean_.size();
  const auto size = old_size + Feature::kCoordinates * static_cast<Eigen::Index>(seeds.size());
  mean_.conservativeResize(size);
  covariance_.conservativeResize(size, size);
  const double variance = sigma_rho * sigma_rho;
  auto offset = old_size;
  for (const auto& seed : seeds) {
    auto& feature = features_.emplace_back(seed.feature);
    feature.offset = static_cast<int>(offset);
    mean_.segment<5>(offset) = seed.coordinates;
    covariance_.block(offset, 0, 5, offset) = seed.J_pose * covariance_.topLeftCorner(3, offset);
    covariance_.block(0, offset, offset, 5) = covariance_.block(offset, 0, 5, offset).transpose();
    Eigen::Matrix<double, 5, 5> own =
        seed.J_pose * covariance_.topLeftCorner<kPose, kPose>() * seed.J_pose.transpose() +
        sigma * sigma * seed.J_pixel * seed.J_pixel.transpose();
    own(4, 4) += variance;
    for (auto other = old_size; other < offset; other += Feature::kCoordinates)
      covariance_(offset + 4, other + 4) = covariance_(other + 4, offset + 4) += 0.5 * variance;
    covariance_.block<5, 5>(offset, offset) = 0.5 * (own + own.transpose());
    offset += Feature::kCoordinates;
  }
}

void convertSure(MonoState& state, const Eigen::Vector3d& centre_now,
                 double largest_linearity_index) {
  std::vector<int> kept_rows(MonoState::kHead);
  std::iota(kept_rows.begin(), kept_rows.end(), 0);
  int offset = MonoState::kHead;
  for (auto& feature : state.features_) {
    const int old_offset = std::exchange(feature.offset, offset);
    const double height = feature.first.centre.z();
    if (!feature.is_point) {
      const InverseDepth y = state.mean_.segment<5>(old_offset);
      const double sigma_rho = std::sqrt(state.covariance_(old_offset + 4, old_offset + 4));
      feature.is_point = linearityIndex(y, height, sigma_rho, centre_now) < largest_linearity_index;
      if (feature.is_point) state.toPoint(old_offset, height);
    }
    for (int i = 0; i < feature.size(); ++i) kept_rows.push_back(old_offset + i);
    offset += feature.size();
  }
  state.compact(kept_rows);
}

/// The point stands where the first three of the five coordinates were.
void MonoState::toPoint(int offset, double height) {
  Eigen::Matrix<double, 3, 5> J;
  mean_.segment<3>(offset) = pointOf(InverseDepth(mean_.segment<5>(offset)), height, &J);
  covariance_.middleRows<3>(offset) = (J * covariance_.middleRows<5>(offset)).eval();
  covariance_.middleCols<3>(offset) = (covariance_.middleCols<5>(offset) * J.transpose()).eval();
}

void MonoState::keep(const std::vector<bool>& kept) {
  std::vector<int> kept_rows(kHead);
  std::iota(kept_rows.begin(), kept_rows.end(), 0);
  std::vector<Feature> features;
  int offset = kHead;
  for (std::size_t i = 0; i < features_.size(); ++i) {
    if (!kept[i]) continue;
    auto& feature = features.emplace_back(std::move(features_[i]));
    const int old_offset = std::exchange(feature.offset, offset);
    for (int k = 0; k < feature.size(); ++k) kept_rows.push_back(old_offset + k);
    offset += feature.size();
  }
  features_ = std::move(features);
  compact(kept_rows);
}

/// In place: a row comes from itself or from one behind it.
void MonoState::compact(const std::vector<int>& kept_rows) {
  const auto size = static_cast<Eigen::Index>(kept_rows.size());
  if (size == mean_.size()) return;
  for (Eigen::Index i = 0; i < size; ++i) mean_(i) = mean_(kept_rows[std::size_t(i)]);
  for (Eigen::Index j = 0; j < size; ++j)
    for (Eigen::Index i = 0; i < size; ++i)
      covariance_(i, j) = covariance_(kept_rows[std::size_t(i)], kept_rows[std::size_t(j)]);
  mean_.conservativeResize(size);
  covariance_.conservativeResize(size, size);
}

}  // namespace slam::mono_ekf
