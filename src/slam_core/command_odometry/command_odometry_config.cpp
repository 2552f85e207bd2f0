// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/command_odometry/command_odometry.hpp"

namespace slam::command_odometry {
namespace {

void describeBase(CommandOdometryConfig& config, Fields& fields) {
  fields
      .add("time_constant", &config.time_constant,
           "the base follows a command with a lag of first order; after this time 63 % of a change "
           "are done")
      .unit("s")
      .in(Range::closed(0, 10))
      .ofRobot();
  fields.add("timeout", &config.timeout, "the base stops when it has had no command for this long")
      .unit("s")
      .in(Range::open(0, 60))
      .ofRobot();
  fields
      .add("max_speed", &config.max_speed,
           "what the robot can do at most; a command beyond it counts as this")
      .unit("m/s")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_turn_rate", &config.max_turn_rate,
           "what the robot can do at most; a command beyond it counts as this")
      .unit("rad/s")
      .in(Range::above(0))
      .ofRobot();
}

void describeNoise(OdometryNoise& noise, Fields& fields) {
  const auto add = [&fields](const char* key, double* alpha, const char* sentence,
                             const char* unit) {
    fields.add(key, alpha, sentence).unit(unit).in(Range::atLeast(0)).ofRobot();
  };
  add("alpha1", &noise.alpha1, "translation to translation variance", "1");
  add("alpha2", &noise.alpha2, "rotation to translation variance", "m^2/rad^2");
  add("alpha3", &noise.alpha3, "translation to rotation variance", "rad^2/m^2");
  add("alpha4", &noise.alpha4, "rotation to rotation variance", "1");
  add("alpha5", &noise.alpha5, "translation to final rotation variance", "rad^2/m^2");
  add("alpha6", &noise.alpha6, "rotation to final rotation variance", "1");
  fields
      .add("omnidirectional", &noise.omnidirectional,
           "the base slips across its way as much as along it")
      .ofRobot();
}

}  // namespace

void CommandOdometryConfig::describe(Fields& fields) {
  describeBase(*this, fields);
  describeNoise(noise, fields);
  fields
      .add("error_time", &error_time,
           "an error of speed and turn rate lasts for this long at least, however often a command "
           "is repeated; the alphas belong to such a time")
      .unit("s")
      .in(Range::closed(0, 10))
      .ofRobot();
  fields
      .add("floor_position", &floor_position,
           "standard deviation of the position after one second, standing or not")
      .unit("m/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("floor_heading", &floor_heading,
           "standard deviation of the heading after one second, standing or not")
      .unit("rad/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
}

}  // namespace slam::command_odometry
