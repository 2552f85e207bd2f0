// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/line_model.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

// Symbols: n the unit perpendicular to the line, t = J n the direction along it, a the anchor, p
// the sensor's position.

namespace slam {
namespace {

Eigen::Vector2d perpendicular(double direction) {
  return {std::cos(direction), std::sin(direction)};
}

Eigen::Vector2d along(double direction) { return {-std::sin(direction), std::cos(direction)}; }

Eigen::Vector2d middleOf(const LandmarkObservation& z) {
  return z.range * perpendicular(z.bearing) +
         (z.extent.begin + z.extent.end) / 2.0 * along(z.bearing);
}

}  // namespace

LineModel::LineModel(const Pose2& T_map_sensor, const LandmarkObservation& z)
    : anchor_(T_map_sensor.transform(middleOf(z))) {}

Eigen::Vector2d LineModel::predict(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                   const Eigen::Vector2d& m_map, Jacobian23* J_z_robot,
                                   Eigen::Matrix2d* J_z_m) const {
  const Pose2 T_map_sensor = T_map_base * T_base_sensor;
  const Eigen::Vector2d n = perpendicular(m_map.y()), offset = anchor_ - T_map_sensor.position();
  if (J_z_robot != nullptr) {
    Jacobian23 J_sensor_robot;
    T_map_base.transform(T_base_sensor.position(), &J_sensor_robot);
    *J_z_robot << -n.transpose() * J_sensor_robot, 0.0, 0.0, -1.0;
  }
  if (J_z_m != nullptr) *J_z_m << 1.0, along(m_map.y()).dot(offset), 0.0, 1.0;
  return {m_map.x() + n.dot(offset), wrapAngle(m_map.y() - T_map_sensor.theta())};
}

Eigen::Vector2d LineModel::invert(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                  const Eigen::Vector2d& z, Jacobian23* J_m_robot,
                                  Eigen::Matrix2d* J_m_z) const {
  const Pose2 T_map_sensor = T_map_base * T_base_sensor;
  const double direction = wrapAngle(z.y() + T_map_sensor.theta());
  const Eigen::Vector2d n = perpendicular(direction), offset = anchor_ - T_map_sensor.position();
  const double lever = along(direction).dot(offset);
  if (J_m_robot != nullptr) {
    Jacobian23 J_sensor_robot;
    T_map_base.transform(T_base_sensor.position(), &J_sensor_robot);
    *J_m_robot << n.transpose() * J_sensor_robot, 0.0, 0.0, 1.0;
    (*J_m_robot)(0, 2) -= lever;
  }
  if (J_m_z != nullptr) *J_m_z << 1.0, -lever, 0.0, 1.0;
  return {z.x() - n.dot(offset), direction};
}

Eigen::Vector2d LineModel::innovation(const Eigen::Vector2d& z,
                                      const Eigen::Vector2d& z_predicted) const {
  return {z.x() - z_predicted.x(), wrapAngle(z.y() - z_predicted.y())};
}

bool LineModel::isSingular(const Eigen::Vector2d& z_predicted) const {
  constexpr double kNearest = 1e-3;  // [m]
  return z_predicted.x() < kNearest;
}

Eigen::Vector2d LineModel::turned(const Eigen::Vector2d& m_map, double angle) const {
  const double from_origin = m_map.x() + perpendicular(m_map.y()).dot(anchor_);
  const double direction = m_map.y() + angle;
  return {from_origin - perpendicular(direction).dot(anchor_), direction};
}

Eigen::Vector2d LineModel::turnDerivative(const Eigen::Vector2d& m_map) const {
  return {-along(m_map.y()).dot(anchor_), 1.0};
}

LineExtent LineModel::extentOf(const Pose2& T_map_sensor, const LandmarkObservation& z,
                               const Eigen::Vector2d& m_map) const {
  const double foot = along(m_map.y()).dot(T_map_sensor.position() - anchor_);
  return {foot + z.extent.begin, foot + z.extent.end};
}

Landmark LineModel::landmarkOf(LandmarkId id, const Eigen::Vector2d& m_map,
                               const LineExtent& extent) const {
  Landmark landmark;
  landmark.id = id;
  landmark.position = anchor_ + m_map.x() * perpendicular(m_map.y());
  landmark.kind = LandmarkKind::kLine;
  landmark.direction = wrapAngle(m_map.y());
  landmark.extent = extent;
  return landmark;
}

LineExtent united(const LineExtent& a, const LineExtent& b) {
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

double gapBetween(const LineExtent& a, const LineExtent& b) {
  return std::max(a.begin, b.begin) - std::min(a.end, b.end);
}

}  // namespace slam
