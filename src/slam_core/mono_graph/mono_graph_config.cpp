// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/mono_graph_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::mono_graph {

void MonoGraphConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "slam builds the map; localization in a fixed map is refused");
  fields.add("features", &features, "an image gives so many features at most")
      .unit("1")
      .in(Range::closed(200, 5000));
  fields
      .add("sigma", &sigma,
           "standard deviation of a feature's place in the image, of those of the finest level")
      .unit("px")
      .in(Range::closed(0.1, 10));
  fields
      .add("keyframe_distance", &keyframe_distance,
           "an image this far from all keyframes nearby becomes one; where it shows few of their "
           "points, 0.4 times the distance or turn are enough")
      .unit("m")
      .in(Range::closed(0.1, 5));
  fields
      .add("keyframe_turn", &keyframe_turn,
           "and one that looks into a direction so far from theirs")
      .unit("rad")
      .in(Range::closed(0.1, 1));
  fields
      .add("window", &window,
           "so many keyframes are adjusted together with the points that they see")
      .unit("1")
      .in(Range::closed(3, 50));
  fields
      .add("least_points", &least_points,
           "the pose follows odometry alone where an image shows fewer points of the map")
      .unit("1")
      .in(Range::closed(6, 1000));
  fields
      .add("most_keyframes", &most_keyframes,
           "so many keyframes are remembered; beyond them the map does not grow")
      .unit("1")
      .in(Range::closed(2, 1000000));
  fields
      .add("least_place_points", &least_place_points,
           "a place is recognised where so many points fit one pose")
      .unit("1")
      .in(Range::closed(10, 1000));
  fields
      .add("least_similarity", &least_similarity,
           "points are compared where an image and a keyframe have this share of their words in "
           "common")
      .unit("1")
      .in(Range::closed(0, 1));
  fields.add(
      "vocabulary", &vocabulary,
      "file with another vocabulary of visual words, as slam_vocabulary writes it; empty: the "
      "one that comes with the program");
}

void requireUsable(const MonoGraphConfig& config) {
  validate(config);
  if (config.mode != BackendMode::kSlam)
    throw ConfigError(
        "mono_graph.mode: the map of a camera's points cannot be kept fixed and localised in: set "
        "mode to slam, or take another back-end");
}

}  // namespace slam::mono_graph
