// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/wheel_encoders.hpp"

#include <Eigen/QR>
#include <cmath>

namespace slam::sim {
namespace {

/// One row a wheel: its way for a body twist (vx, vy, omega).
Eigen::MatrixX3d kinematics(const WheelBase& wheels, double lever) {
  if (wheels.drive == "differential") {
    Eigen::MatrixX3d J(2, 3);
    J << 1, 0, -lever / 2, 1, 0, lever / 2;
    return J;
  }
  Eigen::MatrixX3d J(4, 3);  // mecanum wheels with rollers at 45 degrees
  J << 1, -1, -lever, 1, 1, lever, 1, 1, -lever, 1, -1, lever;
  return J;
}

Eigen::Matrix3d systematicError(const WheelBase& wheels) {
  const Eigen::VectorXd scales = Eigen::Map<const Eigen::VectorXd>(
      wheels.wheel_scales.data(), static_cast<Eigen::Index>(wheels.wheel_scales.size()));
  const Eigen::MatrixXd believed = kinematics(wheels, wheels.lever * wheels.lever_scale);
  const Eigen::MatrixXd ways = scales.asDiagonal() * kinematics(wheels, wheels.lever);
  return believed.completeOrthogonalDecomposition().solve(ways);
}

}  // namespace

WheelEncoders::WheelEncoders(const WheelBase& wheels, const OdometryNoise& noise)
    : systematic_(systematicError(wheels)), noise_(noise) {}

Eigen::Vector3d WheelEncoders::measure(const Eigen::Vector3d& twist, RandomStream& random) const {
  const double d = twist.head<2>().norm(), r = std::abs(twist.z());
  const double translation = std::sqrt(noise_.alpha1 * d + noise_.alpha2 * r);
  const double rotation = std::sqrt(noise_.alpha3 * d + noise_.alpha4 * r);
  const double along = translation * random.gaussian(), across = translation * random.gaussian();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  if (d > 0.0) direction = twist.head<2>() / d;

  Eigen::Vector3d measured = systematic_ * twist;
  measured.head<2>() += along * direction;
  if (noise_.omnidirectional)
    measured.head<2>() += across * Eigen::Vector2d(-direction.y(), direction.x());
  measured.z() += rotation * random.gaussian();
  return measured;
}

void WheelOdometer::moveTo(const Pose2& truth, RandomStream& random) {
  increment_.setZero();
  if (has_started_) increment_ = encoders_.measure(truth_.between(truth).log(), random);
  pose_ = pose_ * Pose2::exp(increment_);
  truth_ = truth;
  has_started_ = true;
}

}  // namespace slam::sim
