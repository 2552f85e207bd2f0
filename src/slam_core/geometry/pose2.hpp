// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam {

/// A pose or displacement in the plane, an element of SE(2): position [m, m], heading [rad] wrapped
/// to (-pi, pi]. T_a_b reads "the pose of b in a". Jacobians are with respect to the coordinates
/// (x, y, theta) and are written only where a pointer is given (Sola, Deray, Atchuthan 2018, app.
/// B; Smith, Self, Cheeseman 1990 for compose and inverse).
class Pose2 {
 public:
  Pose2() = default;
  Pose2(double x, double y, double theta);

  double x() const { return x_; }
  double y() const { return y_; }
  double theta() const { return theta_; }
  Eigen::Vector2d position() const { return {x_, y_}; }
  Eigen::Vector3d vector() const { return {x_, y_, theta_}; }
  Eigen::Matrix2d rotation() const;
  bool isFinite() const;

  static Pose2 fromVector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

  /// The displacement of a constant body twist (vx [m], vy [m], omega [rad]) over unit time.
  static Pose2 exp(const Eigen::Vector3d& twist);
  /// The inverse of exp(): the twist that leads here along an arc.
  Eigen::Vector3d log() const;

  /// The Jacobian of the coordinates of this * exp(twist) in a small twist.
  Eigen::Matrix3d twistJacobian() const;
  /// Ad: this * exp(twist) is exp(Ad twist) * this.
  Eigen::Matrix3d adjoint() const;

  /// T_a_c = T_a_b (this) o T_b_c
  Pose2 compose(const Pose2& b_c, Eigen::Matrix3d* J_ac_ab = nullptr,
                Eigen::Matrix3d* J_ac_bc = nullptr) const;
  /// T_b_a from T_a_b (this)
  Pose2 inverse(Eigen::Matrix3d* J_ba_ab = nullptr) const;
  /// T_b_c from T_a_b (this) and T_a_c
  Pose2 between(const Pose2& a_c) const { return inverse().compose(a_c); }
  /// p_a from p_b, with the 2x3 Jacobian in the pose and the 2x2 one in the point
  Eigen::Vector2d transform(const Eigen::Vector2d& p_b,
                            Eigen::Matrix<double, 2, 3>* J_pa_ab = nullptr,
                            Eigen::Matrix2d* J_pa_pb = nullptr) const;
  /// The displacement after the part `share` in [0, 1] of this one, along the SE(2) geodesic.
  Pose2 part(double share) const { return exp(share * log()); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(x_, y_, theta_);
  }

 private:
  double x_ = 0.0, y_ = 0.0, theta_ = 0.0;
};

inline Pose2 operator*(const Pose2& a_b, const Pose2& b_c) { return a_b.compose(b_c); }

}  // namespace slam
