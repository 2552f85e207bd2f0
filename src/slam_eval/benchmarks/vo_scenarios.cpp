// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vo_scenarios.hpp"

#include <memory>
#include <stdexcept>

#include "slam_sim/drive.hpp"

namespace slam::eval {

std::vector<Scenario> scenariosOf(const sim::World& world, const sim::RobotModel& robot) {
  const auto drive = std::make_shared<const sim::Drive>(world.path, robot);
  const Pose2 start = drive->pose(0.0);
  constexpr double kTurnRate = 0.5, kTurns = 2.0, kStanding = 60.0;
  return {{"drive", drive->duration(), [drive](double t) { return drive->pose(t); }},
          {"turn", kTurns * 2.0 * M_PI / kTurnRate,
           [start](double t) { return start * Pose2(0.0, 0.0, kTurnRate * t); }},
          {"stand", kStanding, [start](double) { return start; }}};
}

std::size_t cameraOf(const sim::RobotModel& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.cameras.size(); ++i)
    if (robot.cameras[i].name == name) return i;
  throw std::runtime_error("the robot " + robot.name + " has no camera '" + name + "'");
}

}  // namespace slam::eval
