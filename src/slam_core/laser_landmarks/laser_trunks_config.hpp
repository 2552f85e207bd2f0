// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::laser_landmarks {

struct LaserTrunksConfig {
  static constexpr const char* kSection = "laser_trunks";

  double sigma_range = 0.05;
  double sigma_bearing = 0.003;
  double max_range = 70.0;
  double max_jump = 0.4;
  double min_diameter = 0.05;
  double max_diameter = 1.5;
  int min_points = 1;
  double max_misfit = 3.3;

  void describe(Fields& fields);
};

}  // namespace slam::laser_landmarks
