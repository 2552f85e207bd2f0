// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/relocalisation_config.hpp"

namespace slam::relocalisation {

void RelocalisationConfig::describe(Fields& fields) {
  fields.add("enabled", &enabled,
             "test the place in a loaded map before it is believed, and look for the robot in the "
             "whole map when it is lost; without this the saved pose counts as the robot's");
  fields
      .add("odds", &odds,
           "a place is believed when it is so many times more likely than that the landmarks seen "
           "are none of the map, and than any other place; in a grid, than a place that only looks "
           "alike")
      .unit("1")
      .in(Range::atLeast(2));
  fields
      .add("outlier_share", &outlier_share,
           "probability that a landmark is not the one of the map that it looks like: a marker "
           "that was moved, or a second one of its id")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("confirmation", &confirmation,
           "a place must remain the most likely one for so long, and odometry must lead there, "
           "before the robot is put there")
      .unit("s")
      .in(Range::atLeast(0));
  fields
      .add("local_way", &local_way,
           "what a laser has seen on so much of the way is looked for in the grid as a whole")
      .unit("m")
      .in(Range::atLeast(0));
  fields
      .add("search_distance", &search_distance,
           "a lost robot searches the grid again after so much of the way")
      .unit("m")
      .in(Range::atLeast(0.05));
}

}  // namespace slam::relocalisation
