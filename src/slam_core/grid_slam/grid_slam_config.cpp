// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_slam/grid_slam_config.hpp"

namespace slam::grid_slam {

void GridSlamConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map, or keep a loaded one and localise in it");
  fields
      .add("insert_distance", &insert_distance,
           "a scan goes into the map when the robot has gone so far since the last one that did")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("insert_angle", &insert_angle, "or when it has turned by so much")
      .unit("rad")
      .in(Range::atLeast(0));
  fields
      .add("initial_sigma_position", &initial_sigma_position,
           "standard deviation of the first pose, which is the map's origin")
      .unit("m")
      .in(Range::closed(1e-6, 100));
  fields
      .add("initial_sigma_heading", &initial_sigma_heading,
           "standard deviation of the first heading")
      .unit("rad")
      .in(Range::closed(1e-6, 10));
  fields
      .add("drift_position", &drift_position,
           "standard deviation by which the map errs after a metre into the unknown; grows with "
           "the root of the way")
      .unit("m")
      .in(Range::closed(0, 1));
  fields.add("drift_heading", &drift_heading, "the same of its heading")
      .unit("rad")
      .in(Range::closed(0, 1));
  fields
      .add("lost_share", &lost_share,
           "a scan does not go into the map when a larger share of its ends than this, of those "
           "where "
           "the map knows something, lies where the map is free")
      .unit("1")
      .in(Range::open(0, 1));
}

}  // namespace slam::grid_slam
