// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/closed_spline.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/robot_model.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// A robot on its path: where it truly is at which time. It starts and ends at rest, and is as fast
/// as the path's speed and the base's limits allow.
class Drive {
 public:
  /// @param path as checkWorld() demands
  Drive(const DrivePath& path, const RobotModel& robot);

  double duration() const { return times_.back(); }    ///< [s]
  double length() const { return distances_.back(); }  ///< of all laps [m]

  /// T_world_base at the time t [s] after the start; at rest before the start and after the end.
  Pose2 pose(double t) const;
  double speed(double t) const;  ///< [m/s]

 private:
  Pose2 poseAt(double s) const;
  double turnPerMetre(double s) const;
  double limitAt(double s, const DriveLimits& limits, double wanted) const;
  void divide(double total);
  void refine(double begin, double end);
  void append(double end, double step);
  bool isAtCusp(std::size_t i) const;
  double turn(double begin, double end) const;
  void limitTurns(double turn_rate);
  void limitAcceleration(double acceleration);
  double distance(double t) const;
  std::size_t segment(double t) const;

  ClosedSpline curve_;
  double sway_, sway_frequency_;                    ///< [rad], [rad/m]
  std::vector<double> steps_;                       ///< between the distances [m]
  std::vector<double> distances_, speeds_, times_;  ///< constant acceleration in between
};

/// @throw ConfigError a base of this radius [m] touches something on its way
void requireClearance(const Drive& drive, const FloorPlan& plan, double radius);

}  // namespace slam::sim
