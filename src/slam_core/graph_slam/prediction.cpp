// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/prediction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

// Symbols: nu innovation, H its Jacobian by (robot as a twist, landmarks), P their covariance, R
// the observations' noise, S = H P H^T + R.

namespace slam::graph_slam {

Prediction::Prediction(const LandmarkGraph& graph, const Pose2& sensor,
                       const std::vector<Match>& matches)
    : robot_(graph.robot().pose), sensor_(sensor), matches_(matches) {
  std::vector<std::size_t> landmarks;
  for (const auto& match : matches) {
    const auto known = std::find(landmarks.begin(), landmarks.end(), match.landmark);
    rows_.push_back(3 + 2 * static_cast<Eigen::Index>(known - landmarks.begin()));
    if (known == landmarks.end()) landmarks.push_back(match.landmark);
    points_.push_back(graph.point(match.landmark));
  }
  P_ = graph.covariance(landmarks);
  const auto size = row(matches.size());
  nu_ = Eigen::VectorXd::Zero(size);
  H_ = Eigen::MatrixXd::Zero(size, P_.rows());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const RangeBearingModel model;
    is_singular_.push_back(model.isSingular(model.predict(robot_, sensor_, points_[i])) ? 1 : 0);
    if (isSingular(i)) continue;
    const auto linear = linearized(i, Eigen::Matrix<double, 5, 1>::Zero());
    nu_.segment<2>(row(i)) = linear.nu;
    H_.block<2, 3>(row(i), 0) = linear.H.leftCols<3>();
    H_.block<2, 2>(row(i), rows_[i]) = linear.H.rightCols<2>();
  }
  S_ = H_ * P_ * H_.transpose();
  for (std::size_t i = 0; i < matches.size(); ++i)
    S_.block<2, 2>(row(i), row(i)) += matches[i].z.covariance;
}

/// The innovation as if linearised where the correction leads.
Prediction::Linear Prediction::linearized(std::size_t match,
                                          const Eigen::Matrix<double, 5, 1>& correction) const {
  const RangeBearingModel model;
  const Pose2 robot = robot_ * Pose2::exp(correction.head<3>());
  ObservationModel::Jacobian23 J_robot;
  Eigen::Matrix2d J_landmark;
  const auto z =
      model.predict(robot, sensor_, points_[match] + correction.tail<2>(), &J_robot, &J_landmark);
  Linear linear;
  linear.H << J_robot * robot.twistJacobian(), J_landmark;
  linear.nu = model.innovation(matches_[match].z.vector(), z) + linear.H * correction;
  return linear;
}

double Prediction::nis(std::size_t match, int linearizations) const {
  constexpr double kConverged = 1e-6;
  Eigen::Matrix<double, 5, 5> P;
  const auto landmark = rows_[match];
  P << P_.topLeftCorner<3, 3>(), P_.block<3, 2>(0, landmark), P_.block<2, 3>(landmark, 0),
      P_.block<2, 2>(landmark, landmark);
  Eigen::Matrix<double, 5, 1> correction = Eigen::Matrix<double, 5, 1>::Zero();
  double nis = 0.0;
  for (int i = 0; i < linearizations; ++i) {
    const auto linear = linearized(match, correction);
    const Eigen::Matrix2d S = linear.H * P * linear.H.transpose() + matches_[match].z.covariance;
    const Eigen::Vector2d weighed = S.inverse() * linear.nu;
    nis = linear.nu.dot(weighed);
    const Eigen::Matrix<double, 5, 1> next = P * linear.H.transpose() * weighed;
    if ((next - correction).norm() < kConverged) break;
    correction = next;
  }
  return nis;
}

bool Prediction::summarize(const std::vector<std::size_t>& used,
                           UpdateStatistics& statistics) const {
  const auto size = row(used.size());
  Eigen::VectorXd nu(size);
  Eigen::MatrixXd S(size, size), H(size, 3), R = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < used.size(); ++i) {
    nu.segment<2>(row(i)) = innovation(used[i]);
    H.middleRows<2>(row(i)) = H_.block<2, 3>(row(used[i]), 0) * robot_.twistJacobian().transpose();
    R.block<2, 2>(row(i), row(i)) = matches_[used[i]].z.covariance;
    for (std::size_t j = 0; j < used.size(); ++j)
      S.block<2, 2>(row(i), row(j)) = crossCovariance(used[i], used[j]);
  }
  const Eigen::LLT<Eigen::MatrixXd> L(S);
  if (L.info() != Eigen::Success || !nu.allFinite()) return false;
  const double log_root = L.matrixLLT().diagonal().array().log().sum();
  statistics.nis = L.matrixL().solve(nu).squaredNorm();
  statistics.nis_dof = static_cast<int>(size);
  statistics.used = static_cast<int>(used.size());
  statistics.log_likelihood -=
      0.5 * (statistics.nis + double(size) * std::log(2.0 * M_PI)) + log_root;
  const auto told = row(std::min(used.size(), UpdateStatistics::kJoint));
  statistics.joint = {nu.head(told), S.topLeftCorner(told, told), R.topLeftCorner(told, told),
                      H.topRows(told)};
  return true;
}

}  // namespace slam::graph_slam
