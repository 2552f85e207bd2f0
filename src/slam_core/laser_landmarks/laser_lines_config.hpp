// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::laser_landmarks {

/// The detectors laser_lines and laser_corners share this section.
struct LaserLinesConfig {
  static constexpr const char* kSection = "laser_lines";

  double sigma_range = 0.01;
  double sigma_bearing = 0.002;
  double sigma_wall = 0.005;
  double max_range = 20.0;
  double max_jump = 0.4;
  double split_distance = 0.05;
  int min_points = 8;
  double min_length = 0.6;
  double max_misfit = 5.0;
  double max_corner_gap = 0.2;
  double min_corner_angle = 0.5;

  void describe(Fields& fields);
};

}  // namespace slam::laser_landmarks
