// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam::grid_slam {

struct GridSlamConfig {
  static constexpr const char* kSection = "grid";

  BackendMode mode = BackendMode::kSlam;
  double insert_distance = 0.4;
  double insert_angle = 0.3;
  double initial_sigma_position = 0.001;
  double initial_sigma_heading = 0.001;
  double drift_position = 0.01;
  double drift_heading = 0.002;
  double lost_share = 0.5;

  void describe(Fields& fields);
};

}  // namespace slam::grid_slam
