// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/seif_config.hpp"

namespace slam::seif {

void SeifConfig::describe(Fields& fields) {
  JointMapConfig::describe(fields);
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
