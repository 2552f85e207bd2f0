// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/calibrated_factors.hpp"

#include <cmath>
#include <utility>

#include "slam_core/models/observation_model.hpp"

// Symbols as in factors.cpp; c the parameters, u a motion, S what scales its error.

namespace slam::graph {
namespace {

/// The keys of two variables, then those of the parameters.
std::vector<Key> withParameters(Key a, Key b, const std::vector<Key>& parameters) {
  std::vector<Key> keys = {a, b};
  keys.insert(keys.end(), parameters.begin(), parameters.end());
  return keys;
}

/// The wheels' parameters among the variables of a motion.
Eigen::Vector3d wheelsOf(const std::vector<Pose2>& at) { return {at[2].x(), at[2].y(), at[3].x()}; }

CalibratedSighting::At sensorOf(const std::vector<Pose2>& at) {
  return {at[2].y(), at[3].position(), at.size() > 4 ? at[4].x() : 0.0};
}

}  // namespace

Pose2 WheelMotion::with(const Eigen::Vector3d& parameters) const {
  return Pose2::fromVector(increment.vector() + J * (parameters - at));
}

Eigen::Vector3d WheelMotion::growth(const Eigen::Vector3d& parameters) const {
  const Eigen::Vector3d off = parameters - at;
  const double way = std::exp(off(kWheelScale));
  return {way, way, way * std::exp(-off(kWheelBase))};
}

ParameterPrior::ParameterPrior(std::vector<Key> keys, const Eigen::VectorXd& known,
                               const Eigen::MatrixXd& W)
    : Factor(std::move(keys)), known_(known), W_(W) {}

LinearFactor ParameterPrior::linearized(const std::vector<Pose2>& at) const {
  Eigen::VectorXd e = -known_;
  for (std::size_t i = 0; i < at.size(); ++i)
    e.segment<2>(2 * static_cast<Eigen::Index>(i)) += at[i].position();
  return {W_ * e, W_};
}

CalibratedBetween::CalibratedBetween(Key a, Key b, const std::vector<Key>& parameters,
                                     const WheelMotion& motion, const Eigen::Matrix3d& W)
    : Factor(withParameters(a, b, parameters)), motion_(motion), W_(W) {}

LinearFactor CalibratedBetween::linearized(const std::vector<Pose2>& at) const {
  const Eigen::Vector3d wheels = wheelsOf(at);
  const Pose2 a_b = at[0].between(at[1]);
  Eigen::Matrix3d J_inverse, J_e_inverse, J_e_ab;
  const Pose2 inverse = motion_.with(wheels).inverse(&J_inverse);
  const Pose2 e = inverse.compose(a_b, &J_e_inverse, &J_e_ab);
  const Eigen::Vector3d S = motion_.growth(wheels).cwiseInverse();
  const Eigen::Matrix3d WS = W_ * S.asDiagonal();
  Eigen::Matrix3d J_a = -inverse.twistJacobian();  // as of Between
  J_a.topRightCorner<2, 1>() = J_a.topLeftCorner<2, 2>() * Eigen::Vector2d(-a_b.y(), a_b.x());
  Eigen::Matrix3d J_wheels = J_e_inverse * J_inverse * motion_.J;
  J_wheels.col(kWheelScale) -= e.vector();  // of S
  J_wheels(2, kWheelBase) += e.theta();
  LinearFactor linear;
  linear.r = WS * e.vector();
  linear.J = Eigen::MatrixXd::Zero(3, 10);
  linear.J.leftCols<3>().noalias() = WS * J_a;
  linear.J.middleCols<3>(3).noalias() = WS * e.twistJacobian();
  linear.J.middleCols<3>(6).noalias() = WS * J_wheels;
  return linear;
}

Between CalibratedBetween::with(const std::vector<Pose2>& at) const {
  const Eigen::Vector3d wheels = wheelsOf(at);
  const Eigen::Matrix3d WS = W_ * motion_.growth(wheels).cwiseInverse().asDiagonal();
  return {keys()[0], keys()[1], motion_.with(wheels), WS};
}

CalibratedSighting::CalibratedSighting(Key pose, Key point, const std::vector<Key>& parameters,
                                       const RangeBearing& seen, const At& then)
    : Factor(withParameters(pose, point, parameters)), seen_(seen), then_(then) {}

RangeBearing CalibratedSighting::with(const std::vector<Pose2>& at) const {
  const auto now = sensorOf(at);
  const Eigen::Vector2d position = seen_.sensor().position() + now.offset - then_.offset;
  const Pose2 sensor(position.x(), position.y(), seen_.sensor().theta() + now.yaw - then_.yaw);
  const double scale = std::exp(now.range_scale - then_.range_scale);
  Eigen::Matrix2d W = seen_.weight();
  W.col(0) /= scale;
  return {keys()[0], keys()[1], sensor, {scale * seen_.measured().x(), seen_.measured().y()}, W};
}

LinearFactor CalibratedSighting::linearized(const std::vector<Pose2>& at) const {
  const RangeBearingModel model;
  const auto now = with(at);
  Eigen::Matrix3d J_sensor_pose, J_sensor_mount;
  const Pose2 sensor = at[0].compose(now.sensor(), &J_sensor_pose, &J_sensor_mount);
  ObservationModel::Jacobian23 J_z_sensor;
  Eigen::Matrix2d J_z_point;
  const auto predicted = model.predict(sensor, Pose2(), at[1].position(), &J_z_sensor, &J_z_point);
  const Eigen::Matrix2d& W =
      now.weight();  // of an error in the map: what was measured has no scale
  const ObservationModel::Jacobian23 J_mount = J_z_sensor * J_sensor_mount;
  LinearFactor linear;
  linear.r = -W * model.innovation(now.measured(), predicted);
  linear.J = Eigen::MatrixXd::Zero(2, 1 + 2 * static_cast<Eigen::Index>(at.size()));
  linear.J.leftCols<3>().noalias() = W * J_z_sensor * J_sensor_pose * at[0].twistJacobian();
  linear.J.middleCols<2>(3).noalias() = W * J_z_point;
  linear.J.col(6).noalias() = W * J_mount.col(2);
  linear.J.middleCols<2>(7).noalias() = W * J_mount.leftCols<2>();
  if (at.size() > 4) linear.J.col(9) = -W.col(0) * predicted.x();
  return linear;
}

}  // namespace slam::graph
