// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/active_path_config.hpp"

#include <cmath>

namespace slam::active_path {
namespace {

void describeSensor(Fields& fields, ActivePathConfig& config) {
  fields.add("robot_radius", &config.robot_radius, "nothing occupied comes nearer to the way")
      .unit("m")
      .in(Range::closed(0.01, 5));
  fields.add("sensor_range", &config.sensor_range, "a beam is expected to see so far")
      .unit("m")
      .in(Range::closed(0.1, 100));
  fields.add("field_of_view", &config.field_of_view, "of the laser, around straight ahead")
      .unit("rad")
      .in(Range::closed(0.1, 6.2832));
  fields.add("rays", &config.rays, "beams that are cast around a viewpoint")
      .unit("1")
      .in(Range::closed(8, 3600));
  fields.add("unknown_way", &config.unknown_way, "mean way of a beam in the unknown until it ends")
      .unit("m")
      .in(Range::closed(0.05, 100));
}

void describeGoals(Fields& fields, ActivePathConfig& config) {
  fields.add("min_frontier", &config.min_frontier, "shorter frontiers are left out")
      .unit("m")
      .in(Range::closed(0, 10));
  fields.add("min_gain", &config.min_gain, "viewpoints that show less are left out")
      .unit("bit m^2")
      .in(Range::above(0));
  fields.add("goal_tolerance", &config.goal_tolerance, "a goal so near to the robot is reached")
      .unit("m")
      .in(Range::closed(0.01, 10));
  fields.add("goal_timeout", &config.goal_timeout, "a goal not reached by then is left out")
      .unit("s")
      .in(Range::above(0));
  fields.add("left_out_time", &config.left_out_time, "for how long, the first time")
      .unit("s")
      .in(Range::above(0));
  fields
      .add("left_out_radius", &config.left_out_radius, "what is so near to it is left out with it")
      .unit("m")
      .in(Range::closed(0, 10));
  fields
      .add("better_factor", &config.better_factor,
           "a goal is given up for one whose gain per metre of way is so many times as large")
      .unit("1")
      .in(Range::closed(1, 100));
}

void describeLoops(Fields& fields, ActivePathConfig& config) {
  fields
      .add("max_sigma", &config.max_sigma,
           "standard deviation of the position beyond which a place seen before is the goal, until "
           "it is below half of it; each way back raises it by half")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("loop_distance", &config.loop_distance,
           "way driven since the robot was at a place, for it to close a loop")
      .unit("m")
      .in(Range::closed(0.1, 1000));
}

}  // namespace

void ActivePathConfig::describe(Fields& fields) {
  describeSensor(fields, *this);
  describeGoals(fields, *this);
  describeLoops(fields, *this);
}

}  // namespace slam::active_path
