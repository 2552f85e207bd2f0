// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_config.hpp"

namespace slam::graph_slam {

Eigen::Vector3d GraphConfig::driftPerMetre() const {
  return Eigen::Vector3d(drift_position, drift_position, drift_heading).cwiseAbs2();
}

void GraphConfig::describe(Fields& fields) {
  JointMapConfig::describe(fields);
  fields
      .add("node_distance", &node_distance,
           "the graph gets a new pose when the robot has moved so far; what is seen before that is "
           "joined to the last one")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("node_angle", &node_angle, "or has turned so far").unit("rad").in(Range::atLeast(0));
  fields
      .add("nodes_per_place", &nodes_per_place,
           "a pose is removed some time after where so many older ones stay within 1 m and 45 "
           "degrees of it")
      .unit("1")
      .in(Range::closed(1, 1000000));
  fields
      .add("iterations", &iterations,
           "a step optimises the graph at most so often, until poses no longer move by centimetres")
      .unit("1")
      .in(Range::closed(1, 50));
  describeScans(fields);
}

void GraphConfig::describeScans(Fields& fields) {
  fields
      .add("insert_distance", &insert_distance,
           "a scan goes into the map when the robot has gone so far since the last one that did")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("insert_angle", &insert_angle, "or when it has turned by so much")
      .unit("rad")
      .in(Range::atLeast(0));
  fields
      .add(
          "submap_way", &submap_way,
          "scans of so long a way go into one submap, and scans are matched with those of at least "
          "so long a way")
      .unit("m")
      .in(Range::closed(1, 1000));
  fields
      .add(
          "drift_position", &drift_position,
          "standard deviation by which a submap errs after a metre; grows with the root of the way")
      .unit("m")
      .in(Range::closed(1e-4, 1));
  fields.add("drift_heading", &drift_heading, "the same of its heading")
      .unit("rad")
      .in(Range::closed(1e-4, 1));
  fields
      .add("lost_share", &lost_share,
           "a scan does not go into the map when a larger share of its ends than this, of those "
           "where the map knows something, lies where the map is free")
      .unit("1")
      .in(Range::open(0, 1));
}

}  // namespace slam::graph_slam
