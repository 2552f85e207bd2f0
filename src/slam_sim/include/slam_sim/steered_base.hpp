// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/robot_model.hpp"

namespace slam::sim {

/// A base that obeys commanded velocities within its limits. It stops half a second after the last
/// command, and at walls and furniture.
class SteeredBase {
 public:
  static constexpr double kCommandLifetime = 0.5;  // [s]

  /// @param plan must outlive this
  SteeredBase(const FloorPlan& plan, const RobotModel& robot) : plan_(plan), robot_(robot) {}

  /// Puts the base somewhere, at rest.
  void place(const Pose2& T_world_base);

  /// A differential base leaves vy out. @param velocity (vx, vy, omega) [m/s, m/s, rad/s]
  void command(const Eigen::Vector3d& velocity);

  /// @param dt [s]
  void advance(double dt);

  const Pose2& pose() const { return pose_; }                    ///< T_world_base
  const Eigen::Vector3d& velocity() const { return velocity_; }  ///< in the base frame
  bool touches() const { return touches_; }                      ///< held back by something

 private:
  void approachCommand(double dt);
  bool isBlocked(const Pose2& next) const;

  const FloorPlan& plan_;
  RobotModel robot_;
  Pose2 pose_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero(), command_ = Eigen::Vector3d::Zero();
  double command_age_ = 0.0;  ///< [s]
  bool touches_ = false;
};

}  // namespace slam::sim
