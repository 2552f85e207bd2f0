// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

/// Private parameters of a nodelet that owns an estimator.
struct OutputsConfig {
  static constexpr const char* kSection = "";

  std::string output_dir;
  std::string load_map;
  std::string load_session;
  std::string save_on_exit;
  double landmark_rate = 2.0;
  double map_period = 2.0;
  double points_rate = 1.0;
  double tf_rate = 20.0;
  double transform_tolerance = 0.1;

  void describe(slam::Fields& fields) {
    fields.add("output_dir", &output_dir,
               "folder for the files of the run; none are written without");
    fields.add("load_map", &load_map,
               "a landmarks' file, a grid's yaml with its landmarks, or a folder, to start with");
    fields.add("load_session", &load_session,
               "a session that save_session has written, to go on from instead of a map");
    fields.add(
        "save_on_exit", &save_on_exit,
        "folder that gets the map at the end: landmarks.yaml, of a grid map.yaml and map.pgm");
    fields.add("landmark_rate", &landmark_rate, "of the landmarks, their markers and the path")
        .unit("1/s of stamps")
        .in(slam::Range::above(0))
        .is_live = true;
    fields.add("map_period", &map_period, "of the grid map and the graph's markers, at least")
        .unit("s of stamps")
        .in(slam::Range::above(0))
        .is_live = true;
    fields.add("points_rate", &points_rate, "of the point map, where it is made in this nodelet")
        .unit("1/s of stamps")
        .in(slam::Range::above(0));
    fields.add("tf_rate", &tf_rate, "of the map's transform")
        .unit("Hz")
        .in(slam::Range::closed(0.1, 1000))
        .is_live = true;
    fields
        .add("transform_tolerance", &transform_tolerance, "how far ahead the transform is stamped")
        .unit("s")
        .in(slam::Range::closed(0, 10))
        .is_live = true;
  }
};

}  // namespace slam_ros
