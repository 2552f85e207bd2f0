// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::laser_landmarks {

struct LaserReflectorsConfig {
  static constexpr const char* kSection = "laser_reflectors";

  double contrast = 4.0;
  double range_exponent = 2.0;
  double sigma_range = 0.02;
  double sigma_bearing = 0.003;
  double max_range = 30.0;
  double max_jump = 0.2;
  double radius = 0.0;
  double min_width = 0.02;
  double max_width = 0.5;

  void describe(Fields& fields);
};

}  // namespace slam::laser_landmarks
