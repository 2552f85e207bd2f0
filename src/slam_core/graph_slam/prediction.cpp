// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/prediction.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

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

/// Where the landmark lies in the robot's frame after a correction. Robot and landmark are moved by
/// the group's exponential, as in an invariant filter (Barrau and Bonnabel 2015): an error of
/// heading that both have in common turns both, and does not change how one looks from the other.
Eigen::Vector2d Prediction::placeInRobot(std::size_t match,
                                         const Eigen::Matrix<double, 5, 1>& correction,
                                         Eigen::Matrix<double, 2, 5>& J) const {
  constexpr double kSmall = 1e-6;
  const double omega = correction(2);
  const Eigen::Vector2d before = robot_.inverse().transform(points_[match]);
  const Eigen::Vector2d sideways(-before.y(), before.x());
  Eigen::Matrix<double, 2, 5> J_u;  // of the displacement to first order
  J_u << -Eigen::Matrix2d::Identity(), -sideways, robot_.rotation().transpose();
  const Eigen::Vector2d u = J_u * correction;
  Eigen::Matrix2d V, V_omega;  // the mean of the rotations on the way, its derivative
  V << Pose2::exp({1, 0, -omega}).position(), Pose2::exp({0, 1, -omega}).position();
  if (std::abs(omega) > kSmall)
    V_omega = (Pose2(0, 0, -omega).rotation() - V) / omega;
  else
    V_omega << 0, 0.5, -0.5, 0;
  J = V * J_u;
  J.col(2) += V_omega * u;
  return before + V * u;
}

/// The innovation as if linearised where the correction leads.
Prediction::Linear Prediction::linearized(std::size_t match,
                                          const Eigen::Matrix<double, 5, 1>& correction) const {
  const RangeBearingModel model;
  Eigen::Matrix<double, 2, 5> J_place;
  const auto place = placeInRobot(match, correction, J_place);
  Eigen::Matrix2d J_z;
  const auto z = model.predict(Pose2(), sensor_, place, nullptr, &J_z);
  Linear linear;
  linear.H = J_z * J_place;
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

Prediction::Joint Prediction::linearized(const std::vector<std::size_t>& used,
                                         const Eigen::VectorXd& correction) const {
  const auto size = row(used.size());
  Joint joint{Eigen::VectorXd(size),
              Eigen::MatrixXd::Zero(size, P_.rows()),
              Eigen::MatrixXd::Zero(size, size),
              {},
              {}};
  for (std::size_t i = 0; i < used.size(); ++i) {
    const auto landmark = rows_[used[i]];
    Eigen::Matrix<double, 5, 1> of_match;
    of_match << correction.head<3>(), correction.segment<2>(landmark);
    const auto linear = linearized(used[i], of_match);
    joint.nu.segment<2>(row(i)) = linear.nu;
    joint.H.block<2, 3>(row(i), 0) = linear.H.leftCols<3>();
    joint.H.block<2, 2>(row(i), landmark) = linear.H.rightCols<2>();
    joint.R.block<2, 2>(row(i), row(i)) = matches_[used[i]].z.covariance;
  }
  return joint;
}

bool Prediction::solve(Joint& joint) const {
  joint.S = joint.H * P_ * joint.H.transpose() + joint.R;
  joint.L.compute(joint.S);
  return joint.L.info() == Eigen::Success && joint.nu.allFinite();
}

/// Linearised again where the correction leads, until what is predicted there is what the last
/// linearisation said, to a hundredth of a sigma in the mean.
Prediction::Joint Prediction::iterated(const std::vector<std::size_t>& used, Joint joint) const {
  constexpr int kLinearizations = 5;
  constexpr double kLinear = 0.01;
  for (int i = 1; i < kLinearizations; ++i) {
    const Eigen::VectorXd correction = P_ * joint.H.transpose() * joint.L.solve(joint.nu);
    auto next = linearized(used, correction);
    const Eigen::VectorXd off = next.nu - joint.nu - (next.H - joint.H) * correction;
    const double squared = off.cwiseAbs2().cwiseQuotient(joint.R.diagonal()).mean();
    if (squared < kLinear * kLinear || !solve(next)) break;
    joint = std::move(next);
  }
  return joint;
}

bool Prediction::summarize(const std::vector<std::size_t>& used,
                           UpdateStatistics& statistics) const {
  auto first = linearized(used, Eigen::VectorXd::Zero(P_.rows()));
  if (!solve(first)) return false;
  const auto joint = iterated(used, std::move(first));
  const double log_root = joint.L.matrixLLT().diagonal().array().log().sum();
  const auto size = row(used.size());
  statistics.nis = joint.L.matrixL().solve(joint.nu).squaredNorm();
  statistics.nis_dof = static_cast<int>(size);
  statistics.used = static_cast<int>(used.size());
  statistics.log_likelihood -=
      0.5 * (statistics.nis + double(size) * std::log(2.0 * M_PI)) + log_root;
  const auto told = row(std::min(used.size(), UpdateStatistics::kJoint));
  statistics.joint = {joint.nu.head(told), joint.S.topLeftCorner(told, told),
                      joint.R.topLeftCorner(told, told),
                      joint.H.topLeftCorner(told, 3) * robot_.twistJacobian().transpose()};
  return true;
}

}  // namespace slam::graph_slam
