// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/pose2.hpp"

#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam {
namespace {

/// sin(t)/t and (1 - cos(t))/t, by their series where the quotient loses digits.
struct ArcFactors {
  explicit ArcFactors(double t) {
    if (std::abs(t) < 1e-4) {
      along = 1.0 - t * t / 6.0;
      across = t / 2.0 * (1.0 - t * t / 12.0);
    } else {
      along = std::sin(t) / t;
      const double half = std::sin(t / 2.0);
      across = 2.0 * half * half / t;  // 1 - cos(t) would cancel
    }
  }
  double along, across;
};

}  // namespace

Pose2::Pose2(double x, double y, double theta) : x_(x), y_(y), theta_(wrapAngle(theta)) {}

Eigen::Matrix2d Pose2::rotation() const {
  const double c = std::cos(theta_), s = std::sin(theta_);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

bool Pose2::isFinite() const {
  return std::isfinite(x_) && std::isfinite(y_) && std::isfinite(theta_);
}

Pose2 Pose2::exp(const Eigen::Vector3d& twist) {
  const ArcFactors arc(twist.z());
  return {arc.along * twist.x() - arc.across * twist.y(),
          arc.across * twist.x() + arc.along * twist.y(), twist.z()};
}

Eigen::Vector3d Pose2::log() const {
  const ArcFactors arc(theta_);
  const double scale = 1.0 / (arc.along * arc.along + arc.across * arc.across);
  return {scale * (arc.along * x_ + arc.across * y_), scale * (arc.along * y_ - arc.across * x_),
          theta_};
}

Eigen::Matrix3d Pose2::twistJacobian() const {
  const double c = std::cos(theta_), s = std::sin(theta_);
  return (Eigen::Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

Eigen::Matrix3d Pose2::adjoint() const {
  Eigen::Matrix3d Ad = twistJacobian();
  Ad(0, 2) = y_;
  Ad(1, 2) = -x_;
  return Ad;
}

Pose2 Pose2::compose(const Pose2& b_c, Eigen::Matrix3d* J_ac_ab, Eigen::Matrix3d* J_ac_bc) const {
  const double c = std::cos(theta_), s = std::sin(theta_);
  const double dx = c * b_c.x_ - s * b_c.y_, dy = s * b_c.x_ + c * b_c.y_;
  if (J_ac_ab != nullptr) *J_ac_ab << 1, 0, -dy, 0, 1, dx, 0, 0, 1;
  if (J_ac_bc != nullptr) *J_ac_bc << c, -s, 0, s, c, 0, 0, 0, 1;
  return {x_ + dx, y_ + dy, theta_ + b_c.theta_};
}

Pose2 Pose2::inverse(Eigen::Matrix3d* J_ba_ab) const {
  const double c = std::cos(theta_), s = std::sin(theta_);
  const Pose2 b_a(-c * x_ - s * y_, s * x_ - c * y_, -theta_);
  if (J_ba_ab != nullptr) *J_ba_ab << -c, -s, b_a.y_, s, -c, -b_a.x_, 0, 0, -1;
  return b_a;
}

Eigen::Vector2d Pose2::transform(const Eigen::Vector2d& p_b, Eigen::Matrix<double, 2, 3>* J_pa_ab,
                                 Eigen::Matrix2d* J_pa_pb) const {
  const Eigen::Matrix2d R = rotation();
  const Eigen::Vector2d offset = R * p_b;
  if (J_pa_ab != nullptr) *J_pa_ab << 1, 0, -offset.y(), 0, 1, offset.x();
  if (J_pa_pb != nullptr) *J_pa_pb = R;
  return position() + offset;
}

}  // namespace slam
