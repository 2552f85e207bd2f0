// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// How a point landmark looks to a sensor on the robot. z: the observation, 2 numbers; m: the
/// landmark in the map frame [m]. Jacobians are written only where a pointer is given.
class ObservationModel {
 public:
  using Jacobian23 = Eigen::Matrix<double, 2, 3>;

  virtual ~ObservationModel() = default;

  /// What the sensor should see, z = h(robot, m).
  virtual Eigen::Vector2d predict(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                  const Eigen::Vector2d& m_map, Jacobian23* J_z_robot = nullptr,
                                  Eigen::Matrix2d* J_z_m = nullptr) const = 0;
  /// Where the landmark must be, m = h^-1(robot, z).
  virtual Eigen::Vector2d invert(const Pose2& T_map_base, const Pose2& T_base_sensor,
                                 const Eigen::Vector2d& z, Jacobian23* J_m_robot = nullptr,
                                 Eigen::Matrix2d* J_m_z = nullptr) const = 0;
  /// z - z_predicted, angles wrapped.
  virtual Eigen::Vector2d innovation(const Eigen::Vector2d& z,
                                     const Eigen::Vector2d& z_predicted) const = 0;
  /// Whether the landmark lies too near the sensor for the Jacobians to mean anything.
  virtual bool isSingular(const Eigen::Vector2d& z_predicted) const = 0;
};

/// Range [m] and bearing [rad], Eq. 5.3 and its inverse, Eq. 5.4, with the sensor's full pose on
/// the robot (the thesis has its position only).
class RangeBearingModel final : public ObservationModel {
 public:
  Eigen::Vector2d predict(const Pose2& T_map_base, const Pose2& T_base_sensor,
                          const Eigen::Vector2d& m_map, Jacobian23* J_z_robot = nullptr,
                          Eigen::Matrix2d* J_z_m = nullptr) const override;
  Eigen::Vector2d invert(const Pose2& T_map_base, const Pose2& T_base_sensor,
                         const Eigen::Vector2d& z, Jacobian23* J_m_robot = nullptr,
                         Eigen::Matrix2d* J_m_z = nullptr) const override;
  Eigen::Vector2d innovation(const Eigen::Vector2d& z,
                             const Eigen::Vector2d& z_predicted) const override;
  bool isSingular(const Eigen::Vector2d& z_predicted) const override;
};

}  // namespace slam
