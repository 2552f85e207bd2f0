// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/unscented_transform.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

// Symbols: L a root of a covariance, P = L L^T; of n errors the sigma points are the centre and
// +-s L_j, the columns of L, of weight w each.

namespace slam::ekf {
namespace {

using Eigen::Index;

/// Spread and weight of the sigma points of n errors. With n + kappa = 3 the points also have a
/// Gaussian's fourth moments along each axis; kappa is never negative, so that no weight is.
struct Spread {
  explicit Spread(int n) : s2(std::max(3, n)), w(0.5 / s2), s(std::sqrt(s2)) {}
  double s2, w, s;
};

/// A root of a covariance that may be singular.
Eigen::Matrix3d rootOf(const Eigen::Matrix3d& P) {
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(P);
  const Eigen::Vector3d D = ldlt.vectorD().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Matrix3d L = ldlt.matrixL();
  return ldlt.transpositionsP().transpose() * (L * D.asDiagonal());
}

/// Whether sigma points of these covariances of poses lie less than half a turn from the centre:
/// beyond, an angle on the circle is no error any more.
bool isWithinHalfATurn(const Spread& spread, const Eigen::Matrix3d& P, const Eigen::Matrix3d& Q) {
  return spread.s2 * std::max(P(2, 2), Q(2, 2)) < M_PI * M_PI;
}

/// What H sees of the errors, as a move of the landmark: delta = B e [m, or of a line m and rad].
Eigen::Matrix<double, 2, 6> relativeError(const Innovation& h) {
  const Eigen::Matrix2d inverse = h.H_landmark.inverse();
  Eigen::Matrix<double, 2, 6> B;
  B << inverse * h.H_robot, inverse * h.H_heading, Eigen::Matrix2d::Identity();
  return B;
}

/// A function of two Gaussian variables of root L, by its values at the sigma points relative to
/// that at the centre, d: odd parts make the slope, even ones the mean and the unexplained rest.
struct PlaneRegression {
  template <class Function>
  PlaneRegression(const Eigen::Matrix2d& L, const Function& d) {
    const Spread spread(2);
    Eigen::Matrix2d odd, even;
    for (Index j = 0; j < 2; ++j) {
      const Eigen::Vector2d plus = d(spread.s * L.col(j)), minus = d(-spread.s * L.col(j));
      odd.col(j) = (plus - minus) / (2.0 * spread.s);
      even.col(j) = plus + minus;
    }
    A = L.transpose().triangularView<Eigen::Upper>().solve(odd.transpose()).transpose();
    mean = spread.w * even.rowwise().sum();
    rest = 0.5 * spread.w * even * even.transpose() - mean * mean.transpose();
  }
  Eigen::Matrix2d A;
  Eigen::Vector2d mean;
  Eigen::Matrix2d rest;
};

}  // namespace

RobotTransition UnscentedTransform::predict(const Linearization& linearization,
                                            const PoseEstimate& robot, const Pose2& increment,
                                            const Eigen::Matrix3d& Q) const {
  const Spread spread(6);  // of robot and increment
  if (!isWithinHalfATurn(spread, robot.covariance, Q))
    return TaylorTransform().predict(linearization, robot, increment, Q);
  const Eigen::Matrix3d L = spread.s * rootOf(robot.covariance), N = spread.s * rootOf(Q);
  std::array<Pose2, 12> moved;
  Eigen::Matrix<double, 3, 12> e;  // before the motion
  e << L, -L, Eigen::Matrix<double, 3, 6>::Zero();
  for (Index j = 0; j < 3; ++j) {
    const auto i = static_cast<std::size_t>(j);
    moved[i] = linearization.moved(robot.pose, L.col(j)) * increment;
    moved[i + 3] = linearization.moved(robot.pose, -L.col(j)) * increment;
    moved[i + 6] = robot.pose * Pose2::fromVector(increment.vector() + N.col(j));
    moved[i + 9] = robot.pose * Pose2::fromVector(increment.vector() - N.col(j));
  }
  RobotTransition transition;
  auto& [F, Q_pose] = transition.error;
  const Pose2 centre = robot.pose.compose(increment, nullptr, &transition.G);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& pose : moved) mean += spread.w * linearization.correctionTo(centre, pose);
  transition.robot = linearization.moved(centre, mean);
  const Eigen::Vector2d way = transition.robot.position() - robot.pose.position();
  F << 1, 0, -way.y(), 0, 1, way.x(), 0, 0, 1;
  Q_pose.setZero();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Eigen::Vector3d rest =
        linearization.correctionTo(transition.robot, moved[i]) - F * e.col(static_cast<Index>(i));
    Q_pose += spread.w * rest * rest.transpose();
  }
  return transition;
}

void UnscentedTransform::observe(const ObservedLandmark& observed, const ObservedCovariance& P,
                                 Innovation& innovation) const {
  constexpr double kSmallest = 1e-6;  // [m, rad] the sigma with which a known place is sampled
  const auto& landmark = observed.landmark;
  const auto& model = landmark.modelOr(observed.model);
  const Eigen::Matrix<double, 2, 6> B = relativeError(innovation);
  const Eigen::Matrix2d C =
      B * P * B.transpose() + kSmallest * kSmallest * Eigen::Matrix2d::Identity();
  const Eigen::LLT<Eigen::Matrix2d> llt(C);
  if (!C.allFinite() || llt.info() != Eigen::Success) return;  // as the linearisation has it
  const auto predicted = [&](const Eigen::Vector2d& m) {
    return model.predict(observed.robot, observed.sensor, m);
  };
  const Eigen::Vector2d centre = predicted(landmark.now);
  const PlaneRegression regression(llt.matrixL(), [&](const Eigen::Vector2d& move) {
    return model.innovation(predicted(landmark.now + move), centre);
  });
  innovation.nu = model.innovation(observed.z.vector(), centre + regression.mean);
  innovation.R += regression.rest;
  innovation.H_robot = regression.A * B.leftCols<3>();
  innovation.H_heading = regression.A * B.col(3);
  innovation.H_landmark = regression.A;
}

Eigen::Matrix3d UnscentedTransform::meanSquaredError(const Linearization& linearization,
                                                     const PoseEstimate& robot) const {
  const Spread spread(3);
  const Eigen::Matrix3d L = spread.s * rootOf(robot.covariance);
  Eigen::Matrix3d squared = Eigen::Matrix3d::Zero();
  for (Index j = 0; j < 3; ++j)
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector3d e = sign * L.col(j);
      e.head<2>() = linearization.moved(robot.pose, e).position() - robot.pose.position();
      squared += spread.w * e * e.transpose();
    }
  return squared;
}

}  // namespace slam::ekf
