// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam {

Eigen::Vector2d RangeBearingModel::predict(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                           const Eigen::Vector2d& m_map, Jacobian23* J_z_robot,
                                           Eigen::Matrix2d* J_z_m) const {
  const Pose2 T_map_sensor = T_map_base * T_base_sensor;
  const Eigen::Vector2d d = m_map - T_map_sensor.position();
  const double r2 = d.squaredNorm(), r = std::sqrt(r2);
  const Eigen::Vector2d z(r, wrapAngle(std::atan2(d.y(), d.x()) - T_map_sensor.theta()));
  if (J_z_robot == nullptr && J_z_m == nullptr) return z;

  Eigen::Matrix2d J_z_d;
  J_z_d << d.x() / r, d.y() / r, -d.y() / r2, d.x() / r2;
  if (J_z_m != nullptr) *J_z_m = J_z_d;
  if (J_z_robot != nullptr) {
    Jacobian23 J_sensor_robot;
    T_map_base.transform(T_base_sensor.position(), &J_sensor_robot);
    *J_z_robot = -J_z_d * J_sensor_robot;
    (*J_z_robot)(1, 2) -= 1.0;
  }
  return z;
}

Eigen::Vector2d RangeBearingModel::invert(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                          const Eigen::Vector2d& z, Jacobian23* J_m_robot,
                                          Eigen::Matrix2d* J_m_z) const {
  const Pose2 T_map_sensor = T_map_base * T_base_sensor;
  const double c = std::cos(T_map_sensor.theta() + z.y());
  const double s = std::sin(T_map_sensor.theta() + z.y());
  const Eigen::Vector2d m = T_map_sensor.position() + z.x() * Eigen::Vector2d(c, s);
  if (J_m_robot != nullptr) {
    const Eigen::Vector2d offset = m - T_map_base.position();
    *J_m_robot << 1, 0, -offset.y(), 0, 1, offset.x();
  }
  if (J_m_z != nullptr) *J_m_z << c, -z.x() * s, s, z.x() * c;
  return m;
}

Eigen::Vector2d RangeBearingModel::innovation(const Eigen::Vector2d& z,
                                              const Eigen::Vector2d& z_predicted) const {
  return {z.x() - z_predicted.x(), wrapAngle(z.y() - z_predicted.y())};
}

bool RangeBearingModel::isSingular(const Eigen::Vector2d& z_predicted) const {
  constexpr double kSmallestRange = 1e-3;  // [m]
  return z_predicted.x() < kSmallestRange;
}

}  // namespace slam
