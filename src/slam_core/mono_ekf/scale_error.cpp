// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/scale_error.hpp"

#include <algorithm>

#include "slam_core/mono_ekf/mono_state.hpp"

namespace slam::mono_ekf {
namespace {

constexpr double kLeastVariance = 1e-12;

/// This is the gradient of a distance's relative error, times its weight. It is in one or two
/// coordinates of the feature; a point has the same with the other sign in the robot's position.
struct OfDistance {
  int at = 0;
  bool is_point = false;
  Eigen::Vector2d weighted;
  double weight = 0.0;
};

OfDistance ofDistance(const MonoState& state, const Feature& feature) {
  const auto& P = state.covariance();
  if (!feature.is_point) {
    const int at = feature.offset + 4;
    const double rho = state.mean()(at), variance = std::max(P(at, at), kLeastVariance);
    return {at, false, {-rho / variance, 0.0}, rho * rho / variance};
  }
  const int at = feature.offset;
  const Eigen::Vector2d vector = state.mean().segment<2>(at) - state.mean().head<2>();
  const Eigen::Matrix2d cross = P.block<2, 2>(at, 0);
  const Eigen::Matrix2d relative =
      P.block<2, 2>(at, at) + P.topLeftCorner<2, 2>() - cross - cross.transpose();
  const double squared = vector.squaredNorm();
  const double inverse = squared / std::max(vector.dot(relative * vector), kLeastVariance);
  return {at, true, inverse * vector, inverse * squared};
}

}  // namespace

ScaleError::ScaleError(const MonoState& state, const std::vector<int>& offsets) {
  std::vector<OfDistance> distances;
  double sum = 0.0;
  for (const auto& feature : state.features()) {
    if (std::find(offsets.begin(), offsets.end(), feature.offset) == offsets.end()) continue;
    distances.push_back(ofDistance(state, feature));
    sum += distances.back().weight;
  }
  if (sum == 0.0) return;
  Eigen::Vector2d of_robot = Eigen::Vector2d::Zero();
  for (const auto& each : distances) {
    const Eigen::Vector2d share = each.weighted / sum;
    gradient_.emplace_back(each.at, share.x());
    if (!each.is_point) continue;
    gradient_.emplace_back(each.at + 1, share.y());
    of_robot -= share;
  }
  for (const int i : {0, 1}) gradient_.emplace_back(i, of_robot(i));
}

double ScaleError::of(const Eigen::VectorXd& errors) const {
  double sum = 0.0;
  for (const auto& [at, part] : gradient_) sum += part * errors(at);
  return sum;
}

Eigen::VectorXd ScaleError::columnsOf(const Eigen::MatrixXd& matrix) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(matrix.rows());
  for (const auto& [at, part] : gradient_) sum += part * matrix.col(at);
  return sum;
}

Eigen::RowVectorXd ScaleError::rowsOf(const Eigen::MatrixXd& matrix) const {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(matrix.cols());
  for (const auto& [at, part] : gradient_) sum += part * matrix.row(at);
  return sum;
}

}  // namespace slam::mono_ekf
