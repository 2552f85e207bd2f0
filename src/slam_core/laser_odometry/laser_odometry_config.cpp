// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_odometry_config.hpp"

namespace slam::laser_odometry {

void LaserOdometryConfig::describe(Fields& fields) {
  fields.add("resolution", &resolution, "edge of a cell of the map that scans are matched with")
      .unit("m")
      .in(Range::closed(0.005, 1.0));
  fields.add("insert_distance", &insert_distance, "a scan goes into that map after this way")
      .unit("m")
      .in(Range::above(0));
  fields.add("insert_angle", &insert_angle, "or after this turn").unit("rad").in(Range::above(0));
  fields
      .add("map_way", &map_way,
           "that map holds what was seen on the last so many metres of the way, and on up to as "
           "many before")
      .unit("m")
      .in(Range::closed(1, 1000));
  fields
      .add("patience", &patience,
           "for how long scans are matched with a map that they do not fit; then a new one begins")
      .unit("s")
      .in(Range::above(0));
  fields
      .add("max_speed", &max_speed,
           "the robot is never faster: how far it may go while neither scans nor wheels tell")
      .unit("m/s")
      .in(Range::above(0))
      .ofRobot();
  fields.add("max_turn_rate", &max_turn_rate, "the robot never turns faster")
      .unit("rad/s")
      .in(Range::above(0))
      .ofRobot();
}

}  // namespace slam::laser_odometry
