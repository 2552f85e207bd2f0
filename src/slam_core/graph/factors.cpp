// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/factors.hpp"

#include <Eigen/Cholesky>
#include <utility>

#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/models/observation_model.hpp"

// Symbols: e the error of a measurement, W its weight, r = W e; J by corrections of poses, which
// are twists (v, omega) in the robot's frame: x exp(v, omega) is x (v, omega) to first order.

namespace slam::graph {
Eigen::MatrixXd weightOfInformation(const Eigen::MatrixXd& information) {
  return Eigen::LLT<Eigen::MatrixXd>(information).matrixU();
}

Eigen::MatrixXd weightOfCovariance(const Eigen::MatrixXd& covariance) {
  constexpr double kLeastVariance = 1e-12;
  const auto size = covariance.rows();
  const Eigen::MatrixXd P = covariance + kLeastVariance * Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> llt(P);
  if (llt.info() == Eigen::Success)
    return llt.matrixL().solve(Eigen::MatrixXd::Identity(size, size));
  const auto axes = principalAxes(P);
  return axes.values.cwiseMax(kLeastVariance).cwiseSqrt().cwiseInverse().asDiagonal() *
         axes.directions.transpose();
}

PosePrior::PosePrior(Key pose, const Pose2& known, const Eigen::Matrix3d& W)
    : Factor({pose}), known_(known), known_inverse_(known.inverse()), W_(W) {}

LinearFactor PosePrior::linearized(const std::vector<Pose2>& at) const {
  const Pose2 e = known_inverse_ * at[0];
  return {W_ * e.vector(), W_ * e.twistJacobian()};
}

PointPrior::PointPrior(Key point, const Eigen::Vector2d& known, const Eigen::Matrix2d& W)
    : Factor({point}), known_(known), W_(W) {}

LinearFactor PointPrior::linearized(const std::vector<Pose2>& at) const {
  return {W_ * (at[0].position() - known_), W_};
}

JointPrior::JointPrior(std::vector<Key> keys, const Pose2& pose,
                       std::vector<Eigen::Vector2d> points, Eigen::MatrixXd W)
    : Factor(std::move(keys)),
      pose_(pose),
      pose_inverse_(pose.inverse()),
      points_(std::move(points)),
      W_(std::move(W)) {}

LinearFactor JointPrior::linearized(const std::vector<Pose2>& at) const {
  const Pose2 e_pose = pose_inverse_ * at[0];
  Eigen::VectorXd e(W_.cols());
  e.head<3>() = e_pose.vector();
  for (std::size_t i = 0; i < points_.size(); ++i)
    e.segment<2>(3 + 2 * static_cast<Eigen::Index>(i)) = at[i + 1].position() - points_[i];
  LinearFactor linear{W_ * e, W_};
  linear.J.leftCols<3>() = W_.leftCols<3>() * e_pose.twistJacobian();
  return linear;
}

Between::Between(Key a, Key b, const Pose2& a_b, const Eigen::Matrix3d& W)
    : Factor({a, b}), a_b_(a_b), b_a_(a_b.inverse()), W_(W) {}

LinearFactor Between::linearized(const std::vector<Pose2>& at) const {
  const Pose2 a_b = at[0].between(at[1]);
  const Pose2 e = b_a_ * a_b;
  // a twist of a moves b's place in a the other way, and turns it around a
  Eigen::Matrix3d J_a = -b_a_.twistJacobian();
  J_a.topRightCorner<2, 1>() = J_a.topLeftCorner<2, 2>() * Eigen::Vector2d(-a_b.y(), a_b.x());
  LinearFactor linear;
  linear.r = W_ * e.vector();
  linear.J.resize(3, 6);
  linear.J.leftCols<3>().noalias() = W_ * J_a;
  linear.J.rightCols<3>().noalias() = W_ * e.twistJacobian();
  return linear;
}

RangeBearing::RangeBearing(Key pose, Key point, const Pose2& base_sensor, const Eigen::Vector2d& z,
                           const Eigen::Matrix2d& W)
    : Factor({pose, point}), base_sensor_(base_sensor), z_(z), W_(W) {}

LinearFactor RangeBearing::linearized(const std::vector<Pose2>& at) const {
  const RangeBearingModel model;
  const auto& pose = at[0];
  ObservationModel::Jacobian23 J_pose;
  Eigen::Matrix2d J_point;
  const auto predicted = model.predict(pose, base_sensor_, at[1].position(), &J_pose, &J_point);
  LinearFactor linear;
  linear.r = -W_ * model.innovation(z_, predicted);
  linear.J.resize(2, 5);
  linear.J.leftCols<3>().noalias() = W_ * J_pose * pose.twistJacobian();
  linear.J.rightCols<2>().noalias() = W_ * J_point;
  return linear;
}

}  // namespace slam::graph
