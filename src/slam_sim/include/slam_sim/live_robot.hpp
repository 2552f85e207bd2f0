// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "slam_sim/drive.hpp"
#include "slam_sim/sensors.hpp"
#include "slam_sim/steered_base.hpp"

namespace slam::sim {

/// A robot that lives in real time: it follows the world's path until a command comes, or stands
/// still until then. Times [s] are since the start.
class LiveRobot {
 public:
  /// @throw ConfigError it is to follow the path and touches something on it
  LiveRobot(const World& world, const RobotModel& robot, std::uint64_t seed, bool follows_path);

  Sensors& sensors() { return sensors_; }
  const Sensors& sensors() const { return sensors_; }

  /// From now on the base is steered. @param velocity (vx, vy, omega) [m/s, m/s, rad/s]
  void command(const Eigen::Vector3d& velocity);

  /// Moves on to `time` and reads the wheels; a time that is not later is left out.
  /// @return whether it has moved on
  bool advance(double time);

  /// T_world_base at a time near the one of the last advance().
  Pose2 pose(double time) const;
  const WheelOdometer& odometer() const { return odometer_; }
  /// What the wheels measured in the last step (vx, vy, omega) [m/s, m/s, rad/s].
  Eigen::Vector3d measuredVelocity() const;
  bool touches() const { return base_.touches(); }

 private:
  Sensors sensors_;
  std::optional<Drive> drive_;  ///< while it follows the path
  SteeredBase base_;
  WheelOdometer odometer_;
  double time_ = 0.0, step_ = 0.0;
  std::uint64_t readings_ = 0;
};

}  // namespace slam::sim
