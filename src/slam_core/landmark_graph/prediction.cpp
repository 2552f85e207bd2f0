// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/prediction.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

// Symbols: nu innovation, H its Jacobian by (robot as a twist, landmarks), P their covariance, R
// the observations' noise, S = H P H^T + R.

namespace slam::landmark_graph {

Prediction::Prediction(const LandmarkGraph& graph, const Pose2& sensor,
                       const std::vector<Match>& matches, const Viewpoint& from)
    : robot_(graph.robot(from).pose),
      sensor_(sensor),
      J_robot_(robot_.twistJacobian().transpose()),
      matches_(matches) {
  std::vector<std::size_t> landmarks;
  for (const auto& match : matches) {
    const auto known = std::find(landmarks.begin(), landmarks.end(), match.landmark);
    rows_.push_back(3 + 2 * static_cast<Eigen::Index>(known - landmarks.begin()));
    if (known == landmarks.end()) landmarks.push_back(match.landmark);
    points_.push_back(graph.point(match.landmark));
  }
  if (calibrates(graph)) {
    P_ = covarianceFrom(graph, sensor, landmarks, from);
    of_robot_ = sensor.inverse().adjoint();
    robot_ = robot_ * sensor;
    sensor_ = Pose2();
  } else {
    P_ = graph.covariance(landmarks, from);
  }
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const RangeBearingModel model;
    is_singular_.push_back(model.isSingular(model.predict(robot_, sensor_, points_[i])) ? 1 : 0);
    linear_.push_back(isSingular(i) ? Linear()
                                    : linearized(i, Eigen::Matrix<double, 5, 1>::Zero()));
  }
}

Eigen::Matrix2d Prediction::crossCovariance(std::size_t a, const Jacobian& H_a, std::size_t b,
                                            const Jacobian& H_b) const {
  const auto l_a = rows_[a], l_b = rows_[b];
  Eigen::Matrix<double, 5, 5> P;  // of robot and landmark a with robot and landmark b
  P << P_.topLeftCorner<3, 3>(), P_.block<3, 2>(0, l_b), P_.block<2, 3>(l_a, 0),
      P_.block<2, 2>(l_a, l_b);
  return H_a * P * H_b.transpose();
}

/// Where the landmark lies in the robot's frame after a correction. Robot and landmark are moved by
/// the group's exponential, as in an invariant filter (Barrau and Bonnabel 2015): an error of
/// heading that both have in common turns both, and does not change how one looks from the other.
Eigen::Vector2d Prediction::placeInRobot(std::size_t match,
                                         const Eigen::Matrix<double, 5, 1>& correction,
                                         Jacobian& J) const {
  constexpr double kSmall = 1e-6;
  const double omega = correction(2);
  const Eigen::Vector2d before = robot_.inverse().transform(points_[match]);
  const Eigen::Vector2d sideways(-before.y(), before.x());
  Jacobian J_u;  // of the displacement to first order
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
  Jacobian J_place;
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

Prediction::Joint Prediction::linearized(const Used& used,
                                         const Eigen::VectorXd& correction) const {
  Joint joint;
  joint.nu.resize(row(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    Eigen::Matrix<double, 5, 1> of_match;
    of_match << correction.head<3>(), correction.segment<2>(rows_[used[i]]);
    const auto linear = linearized(used[i], of_match);
    joint.nu.segment<2>(row(i)) = linear.nu;
    joint.H.push_back(linear.H);
  }
  return joint;
}

bool Prediction::solve(const Used& used, Joint& joint) const {
  joint.S.resize(joint.nu.size(), joint.nu.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      joint.S.block<2, 2>(row(i), row(j)) =
          crossCovariance(used[i], joint.H[i], used[j], joint.H[j]);
    joint.S.block<2, 2>(row(i), row(i)) =
        crossCovariance(used[i], joint.H[i], used[i], joint.H[i]) + matches_[used[i]].z.covariance;
  }
  joint.S.triangularView<Eigen::StrictlyUpper>() = joint.S.transpose();
  joint.L.compute(joint.S);
  return joint.L.info() == Eigen::Success && joint.nu.allFinite();
}

/// P H^T S^-1 nu.
Eigen::VectorXd Prediction::correctionOf(const Used& used, const Joint& joint) const {
  const Eigen::VectorXd weighed = joint.L.solve(joint.nu);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(P_.rows());  // H^T S^-1 nu
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Eigen::Matrix<double, 5, 1> part = joint.H[i].transpose() * weighed.segment<2>(row(i));
    pull.head<3>() += part.head<3>();
    pull.segment<2>(rows_[used[i]]) += part.tail<2>();
  }
  return P_ * pull;
}

/// @return how much a linearisation differs from the one before, at the correction that this one
/// led
///   to: the mean square, in sigmas of the observations
double Prediction::curvature(const Used& used, const Joint& joint, const Joint& next,
                             const Eigen::VectorXd& correction) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    Eigen::Matrix<double, 5, 1> of_match;
    of_match << correction.head<3>(), correction.segment<2>(rows_[used[i]]);
    const Eigen::Vector2d off = next.nu.segment<2>(row(i)) - joint.nu.segment<2>(row(i)) -
                                (next.H[i] - joint.H[i]) * of_match;
    sum += off.cwiseAbs2().cwiseQuotient(matches_[used[i]].z.covariance.diagonal()).sum();
  }
  return sum / static_cast<double>(joint.nu.size());
}

/// Linearised again where the correction leads, until what is predicted there is what the last
/// linearisation said, to a hundredth of a sigma in the mean.
Prediction::Joint Prediction::iterated(const Used& used, Joint joint) const {
  constexpr int kLinearizations = 5;
  constexpr double kLinear = 0.01;
  for (int i = 1; i < kLinearizations; ++i) {
    const auto correction = correctionOf(used, joint);
    auto next = linearized(used, correction);
    if (curvature(used, joint, next, correction) < kLinear * kLinear || !solve(used, next)) break;
    joint = std::move(next);
  }
  return joint;
}

bool Prediction::summarize(const Used& used, UpdateStatistics& statistics) const {
  auto first = linearized(used, Eigen::VectorXd::Zero(P_.rows()));
  if (!solve(used, first)) return false;
  const auto joint = iterated(used, std::move(first));
  const double log_root = joint.L.matrixLLT().diagonal().array().log().sum();
  const auto size = row(used.size());
  statistics.nis = joint.L.matrixL().solve(joint.nu).squaredNorm();
  statistics.nis_dof = static_cast<int>(size);
  statistics.used = static_cast<int>(used.size());
  statistics.log_likelihood -=
      0.5 * (statistics.nis + double(size) * std::log(2.0 * M_PI)) + log_root;
  statistics.joint = tellable(used, joint);
  return true;
}

/// The first matches, with H by the pose.
JointInnovation Prediction::tellable(const Used& used, const Joint& joint) const {
  const auto count = std::min(used.size(), UpdateStatistics::kJoint);
  const auto size = row(count);
  JointInnovation told{joint.nu.head(size), joint.S.topLeftCorner(size, size),
                       Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd(size, 3)};
  for (std::size_t i = 0; i < count; ++i) {
    told.R.block<2, 2>(row(i), row(i)) = matches_[used[i]].z.covariance;
    told.H.middleRows<2>(row(i)) = joint.H[i].leftCols<3>() * of_robot_ * J_robot_;
  }
  return told;
}

}  // namespace slam::landmark_graph
