// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::laser_odometry {

struct LaserOdometryConfig {
  static constexpr const char* kSection = "laser_odometry";

  double resolution = 0.05;
  double insert_distance = 0.4;
  double insert_angle = 0.3;
  double map_way = 10.0;
  double patience = 1.0;
  double max_speed = 3.0;
  double max_turn_rate = 5.0;

  void describe(Fields& fields);
};

}  // namespace slam::laser_odometry
