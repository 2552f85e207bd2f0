// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/turned_motion.hpp"

#include <Eigen/LU>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/models/arc_jacobian.hpp"

namespace slam::imu_odometry {
namespace {

Pose2 along(const Eigen::Vector2d& way, const gyro::GyroTurn& turn, double bias) {
  Pose2 pose;
  for (const auto& piece : turn.pieces) {
    const Eigen::Vector2d part = way * (piece.seconds / turn.seconds);
    pose = pose * Pose2::exp({part.x(), part.y(), piece.angle - bias * piece.seconds});
  }
  return pose;
}

/// @return the covariance of the body's way (along, across), whatever the heading
Eigen::Matrix2d wayCovariance(const Motion& wheels, const Eigen::Vector3d& twist) {
  const Eigen::Matrix3d J_inverse = arcJacobian(twist).inverse();
  return (J_inverse * wheels.covariance * J_inverse.transpose()).topLeftCorner<2, 2>();
}

}  // namespace

Motion turnedMotion(const Motion& wheels, const gyro::GyroTurn& turn, double bias,
                    double variance) {
  const Eigen::Vector3d measured = wheels.increment.log();
  Motion motion = wheels;
  motion.increment = along(measured.head<2>(), turn, bias);
  Eigen::Matrix3d of_twist = Eigen::Matrix3d::Zero();
  of_twist.topLeftCorner<2, 2>() = wayCovariance(wheels, measured);
  of_twist(2, 2) = variance;
  const Eigen::Matrix3d J =
      arcJacobian({measured.x(), measured.y(), turn.angle - bias * turn.seconds});
  motion.covariance = symmetric(J * of_twist * J.transpose());
  return motion;
}

}  // namespace slam::imu_odometry
