// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/seif_config.hpp"

#include "slam_core/models/landmark_map.hpp"

namespace slam::seif {

void SeifConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map, or keep a loaded one fixed and only localise in it");
  places.describe(fields);
  fields
      .add("gate_probability", &gate_probability,
           "an observation is left out when a right one would lie nearer with this probability")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("initial_sigma_position", &initial_sigma_position,
           "standard deviation of the first position; the first pose defines the map frame")
      .unit("m")
      .in({0, kLargestSigmaPosition, true, false});
  fields
      .add("initial_sigma_heading", &initial_sigma_heading,
           "standard deviation of the first heading; with pi nothing is known of it")
      .unit("rad")
      .in({0, kLargestSigmaHeading, true, false});
  fields
      .add("load_inflation", &load_inflation,
           "factor on the standard deviations of a loaded map that has no joint covariance")
      .unit("1")
      .in(Range::atLeast(1));
  fields
      .add("joint_limit", &joint_limit,
           "a map of more landmarks is saved without its joint covariance, which would fill a file "
           "of hundreds of megabytes")
      .unit("1")
      .in(Range::atLeast(0));
  fields
      .add("active_landmarks", &active_landmarks,
           "after so many different landmarks the poses from which they were seen are "
           "marginalised, so that no more landmarks are joined at once")
      .unit("1")
      .in(Range::closed(3, 1000));
  fields
      .add("interval_nodes", &interval_nodes,
           "the same after so many poses, where there are few landmarks")
      .unit("1")
      .in(Range::closed(2, 10000));
  fields
      .add("interval_heading", &interval_heading,
           "the same when it is less certain than this by how much the robot has turned in between")
      .unit("rad")
      .in(Range::open(0, 3));
  fields
      .add(
          "node_distance", &node_distance,
          "the filter gets a new pose when the robot has moved so far; what is seen before that is "
          "joined to the last one")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("node_angle", &node_angle, "or has turned so far").unit("rad").in(Range::atLeast(0));
  fields
      .add("iterations", &iterations,
           "a step is linearised at most so often, until nothing moves by centimetres any more")
      .unit("1")
      .in(Range::closed(1, 50));
}

}  // namespace slam::seif
