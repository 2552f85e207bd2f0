// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/point_map_config.hpp"

namespace slam::point_map {

void PointMapConfig::describe(Fields& fields) {
  fields.add("fusion", &fusion, {{"euclidean", Fusion::kEuclidean}, {"aligned", Fusion::kAligned}},
             "euclidean: at the filter's pose; aligned: the scan is aligned to the map first");
  fields
      .add("fusion_distance", &fusion_distance,
           "an end point so near to a point of the map is fused with it, else appended")
      .unit("m")
      .in(Range::closed(0.001, 10));
  fields.add("max_points", &max_points, "a map with so many points is full: no more are appended")
      .unit("1")
      .in(Range::closed(1, 50000000));
  fields
      .add("alignment_distance", &alignment_distance,
           "aligned: end points farther from the map are not compared with it")
      .unit("m")
      .in(Range::closed(0.01, 5));
  fields
      .add("alignment_share", &alignment_share,
           "aligned: share of the end points that must find the map, else the filter's pose counts")
      .unit("1")
      .in(Range::closed(0.05, 1));
  fields
      .add("surface_distance", &surface_distance,
           "aligned: across a surface that the map knows well an end point is fused from so far")
      .unit("m")
      .in(Range::closed(0.001, 10));
  fields
      .add("prior_sigma_position", &prior_sigma_position,
           "aligned: how far from the filter's pose the scan is believed to lie")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("prior_sigma_heading", &prior_sigma_heading,
           "aligned: how far from the filter's heading the scan is believed to lie")
      .unit("rad")
      .in(Range::above(0));
}

}  // namespace slam::point_map
