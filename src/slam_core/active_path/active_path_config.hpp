// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::active_path {

/// The component's settings.
struct ActivePathConfig {
  static constexpr const char* kSection = "active_path";

  double robot_radius = 0.25;
  double sensor_range = 5.0;
  double field_of_view = 6.2832;
  int rays = 120;
  double unknown_way = 1.0;
  double min_frontier = 0.3;
  double min_gain = 0.2;
  double goal_tolerance = 0.25;
  double goal_timeout = 60.0;
  double left_out_time = 60.0;
  double left_out_radius = 0.3;
  double better_factor = 1.5;
  double max_sigma = 0.3;
  double loop_distance = 3.0;

  void describe(Fields& fields);
};

}  // namespace slam::active_path
