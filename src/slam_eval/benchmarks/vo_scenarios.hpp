// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/sensors.hpp"

namespace slam::eval {

/// What a robot drives beneath a ceiling.
struct Scenario {
  std::string name;
  double duration = 0.0;                      ///< [s]
  std::function<Pose2(double seconds)> path;  ///< T_world_base
};

/// The world's drive; turning on the spot at 0.5 rad/s; standing for a minute.
std::vector<Scenario> scenariosOf(const sim::World& world, const sim::RobotModel& robot);

/// The camera of that name. @throw std::runtime_error when the robot has none
std::size_t cameraOf(const sim::RobotModel& robot, const std::string& name);

}  // namespace slam::eval
