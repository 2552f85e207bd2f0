// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_model.hpp"

#include <cmath>

#include "slam_core/common/policy_table.hpp"
#include "slam_core/models/arc_jacobian.hpp"

namespace slam {
namespace {

/// Covariance in the plane of noise with the given variances along and across a direction.
Eigen::Matrix2d directed(const Eigen::Vector2d& direction, double along, double across) {
  return across * Eigen::Matrix2d::Identity() +
         (along - across) * direction * direction.transpose();
}

Eigen::Vector2d unitOrForward(const Eigen::Vector2d& v) {
  const double length = v.norm();
  return length > 0.0 ? Eigen::Vector2d(v / length) : Eigen::Vector2d::UnitX();
}

}  // namespace

Eigen::Matrix3d QuadraticMotionModel::covariance(const Pose2& increment) const {
  const Eigen::Vector2d way = increment.position();
  const double d2 = way.squaredNorm(), r2 = increment.theta() * increment.theta();
  const double translation = noise_.alpha1 * d2 + noise_.alpha2 * r2;
  const double rotation = noise_.alpha3 * d2 + noise_.alpha4 * r2;

  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();
  Q.topLeftCorner<2, 2>() =
      directed(unitOrForward(way), translation, noise_.omnidirectional ? translation : 0.0);
  const Eigen::Vector3d J_u_rotation(-way.y(), way.x(), 1.0);  // Eq. 5.1: turns before it drives
  return Q + rotation * J_u_rotation * J_u_rotation.transpose();
}

Eigen::Matrix3d LinearMotionModel::covariance(const Pose2& increment) const {
  const Eigen::Vector3d twist = increment.log();
  const double d = twist.head<2>().norm(), r = std::abs(twist.z());
  const double translation = noise_.alpha1 * d + noise_.alpha2 * r;
  const double rotation = noise_.alpha3 * d + noise_.alpha4 * r;
  const Eigen::Matrix2d slip = directed(unitOrForward(twist.head<2>()), translation,
                                        noise_.omnidirectional ? translation : 0.0);

  // Noise that enters after the share s of the arc: a slip is turned by the heading there, a
  // rotation swings the rest of the way. Simpson's rule is exact on a straight line.
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();
  const struct {
    double share, weight;
  } kSimpson[] = {{0.0, 1.0 / 6.0}, {0.5, 4.0 / 6.0}, {1.0, 1.0 / 6.0}};
  for (const auto& [share, weight] : kSimpson) {
    const Pose2 done = Pose2::exp(share * twist);
    const Eigen::Matrix2d R = done.rotation();
    const Eigen::Vector2d rest = increment.position() - done.position();
    const Eigen::Vector3d J_u_rotation(-rest.y(), rest.x(), 1.0);
    Q.topLeftCorner<2, 2>() += weight * R * slip * R.transpose();
    Q += weight * rotation * J_u_rotation * J_u_rotation.transpose();
  }
  return Q;
}

Eigen::Matrix3d VelocityMotionModel::covariance(const Pose2& increment) const {
  const Eigen::Vector3d twist = increment.log();
  const double d2 = twist.head<2>().squaredNorm(), r2 = twist.z() * twist.z();
  const double speed = noise_.alpha1 * d2 + noise_.alpha2 * r2;

  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  M.topLeftCorner<2, 2>() =
      directed(unitOrForward(twist.head<2>()), speed, noise_.omnidirectional ? speed : 0.0);
  M(2, 2) = noise_.alpha3 * d2 + noise_.alpha4 * r2;
  const Eigen::Matrix3d J_increment_twist = arcJacobian(twist);
  Eigen::Matrix3d Q = J_increment_twist * M * J_increment_twist.transpose();
  Q(2, 2) += noise_.alpha5 * d2 + noise_.alpha6 * r2;
  return Q;
}

namespace {

const PolicyTable<MotionModel, OdometryNoise>& motionModelTable() {
  static const PolicyTable<MotionModel, OdometryNoise> kTable(
      {{"linear", makePolicyOf<MotionModel, LinearMotionModel, OdometryNoise>},
       {"quadratic", makePolicyOf<MotionModel, QuadraticMotionModel, OdometryNoise>},
       {"velocity", makePolicyOf<MotionModel, VelocityMotionModel, OdometryNoise>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& motionModelNames() { return motionModelTable().names(); }

std::unique_ptr<MotionModel> makeMotionModel(const std::string& name, const OdometryNoise& noise) {
  return motionModelTable().make(name, noise);
}

}  // namespace slam
