// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/sensor_frame.hpp"

#include <cmath>

namespace slam::ekf {
namespace {

using Eigen::Index;

constexpr Index kPoseRows = 3;
constexpr Index kHead = kPoseRows + kCalibrationRows;  ///< robot and parameters

/// D(c), with its Jacobian in the parameters.
Pose2 sensorOf(const std::optional<SensorFrame::View>& view, const CalibrationVector& c,
               CalibrationJacobian<3>& J) {
  if (view) return calibrated(view->mount, view->velocity, c, &J);
  J.setZero(kPoseRows, kCalibrationRows);
  return {};
}

/// The inverse of the same.
Pose2 inverseOf(const std::optional<SensorFrame::View>& view, const CalibrationVector& c,
                CalibrationJacobian<3>& J) {
  Eigen::Matrix3d J_inverse;
  const Pose2 inverse = sensorOf(view, c, J).inverse(&J_inverse);
  J = (J_inverse * J).eval();
  return inverse;
}

Eigen::Vector3d scaling(double factor) { return {factor, factor, 1.0}; }

Pose2 scaled(const Pose2& pose, double factor) {
  return {factor * pose.x(), factor * pose.y(), pose.theta()};
}

void scale(Landmark& landmark, double factor) {
  landmark.position *= factor;
  landmark.extent = {factor * landmark.extent.begin, factor * landmark.extent.end};
  const Eigen::Vector2d scales(factor, landmark.isLine() ? 1.0 : factor);
  landmark.covariance = scales.asDiagonal() * landmark.covariance * scales.asDiagonal();
}

/// How a landmark's two numbers grow with s.
Eigen::Vector2d growthOf(const Landmark& landmark) {
  if (!landmark.isLine()) return landmark.position;
  const Eigen::Vector2d normal(std::cos(landmark.direction), std::sin(landmark.direction));
  return {normal.dot(landmark.position), 0.0};
}

}  // namespace

SensorFrame::Transition SensorFrame::between(const std::optional<View>& from, const Transition& U,
                                             const std::optional<View>& to,
                                             const CalibrationVector& c) const {
  CalibrationJacobian<3> J_from, J_to;
  const Pose2 inverse = inverseOf(from, c, J_from), sensor = sensorOf(to, c, J_to);
  Eigen::Matrix3d by_inverse, by_U, by_both, by_sensor;
  const Pose2 both = inverse.compose(U.increment, &by_inverse, &by_U);
  const double factor = std::exp(-c(kRangeScale));
  Transition result;
  result.increment = scaled(both.compose(sensor, &by_both, &by_sensor), factor);
  const Eigen::Vector3d scales = scaling(factor);
  result.J = by_both * (by_inverse * J_from + by_U * U.J) + by_sensor * J_to;
  result.J = (scales.asDiagonal() * result.J).eval();
  result.J.topRows<2>().col(kRangeScale) -= result.increment.position();
  const Eigen::Matrix3d G = scales.asDiagonal() * by_both * by_U;
  result.Q = G * U.Q * G.transpose();
  return result;
}

SensorFrame::Transition SensorFrame::moved(const Transition& U, const CalibrationVector& c) const {
  return between(view_, U, view_, c);
}

SensorFrame::Transition SensorFrame::look(const View& view, const CalibrationVector& c) {
  Transition none;
  none.J.setZero(kPoseRows, kCalibrationRows);
  const auto result = between(view_, none, view, c);
  view_ = view;
  return result;
}

Pose2 SensorFrame::robot(const Pose2& of_filter, const CalibrationVector& c, Jacobian& J) const {
  CalibrationJacobian<3> J_view;
  const Pose2 inverse = inverseOf(view_, c, J_view);
  const double factor = std::exp(c(kRangeScale));
  const Pose2 sensor = scaled(of_filter, factor);
  Eigen::Matrix3d by_sensor, by_inverse;
  const Pose2 robot = sensor.compose(inverse, &by_sensor, &by_inverse);
  J << by_sensor * scaling(factor).asDiagonal(), by_inverse * J_view;
  J.col(kPoseRows + kRangeScale) += by_sensor.leftCols<2>() * sensor.position();
  return robot;
}

PoseEstimate SensorFrame::robot(const Joint& joint) const {
  Jacobian J;
  const Pose2 robot = this->robot(joint.robot, joint.c, J);
  return {robot, J * joint.covariance * J.transpose()};
}

MapState SensorFrame::map(const MapState& map, const CalibrationVector& c) const {
  const double factor = std::exp(c(kRangeScale));
  const Index landmarks = 2 * static_cast<Index>(map.landmarks.size());
  Jacobian J;
  MapState result = map;
  result.robot.pose = robot(map.robot.pose, c, J);
  Eigen::VectorXd scales = Eigen::VectorXd::Constant(landmarks, factor);
  Eigen::VectorXd growth(landmarks);
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    auto& landmark = result.landmarks[i];
    scale(landmark, factor);
    const auto row = 2 * static_cast<Index>(i);
    growth.segment<2>(row) = growthOf(landmark);
    if (landmark.isLine()) scales(row + 1) = 1.0;
  }

  // rows of the result by rows of the filter's: first from the left, then from the right
  const auto fromLeft = [&](const Eigen::MatrixXd& P) {
    Eigen::MatrixXd product(kPoseRows + landmarks, P.cols());
    product.topRows<kPoseRows>() = J * P.topRows<kHead>();
    product.bottomRows(landmarks) =
        scales.asDiagonal() * P.bottomRows(landmarks) + growth * P.row(kPoseRows + kRangeScale);
    return product;
  };
  const Eigen::MatrixXd left = fromLeft(map.joint_covariance);
  result.joint_covariance = fromLeft(left.transpose());
  result.robot.covariance = result.joint_covariance.topLeftCorner<kPoseRows, kPoseRows>();
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const auto row = kPoseRows + 2 * static_cast<Index>(i);
    result.landmarks[i].covariance = result.joint_covariance.block<2, 2>(row, row);
  }
  return result;
}

SensorFrame::Transition fromMetres(const Pose2& in_range_units) {
  SensorFrame::Transition transition;
  transition.J.setZero(kPoseRows, kCalibrationRows);
  transition.J.topRows<2>().col(kRangeScale) =
      -in_range_units.rotation().transpose() * in_range_units.position();
  return transition;
}

PoseEstimate inRangeUnits(PoseEstimate estimate, const CalibrationVector& c) {
  const double factor = std::exp(-c(kRangeScale));
  const Eigen::Vector3d scales = scaling(factor);
  estimate.pose = scaled(estimate.pose, factor);
  estimate.covariance = (scales.asDiagonal() * estimate.covariance * scales.asDiagonal()).eval();
  return estimate;
}

}  // namespace slam::ekf
