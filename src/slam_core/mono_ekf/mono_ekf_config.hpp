// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam::mono_ekf {

struct MonoEkfConfig {
  static constexpr const char* kSection = "mono_ekf";

  BackendMode mode = BackendMode::kSlam;
  int features_in_view = 40;
  int most_features = 250;
  double pixel_sigma = 0.2;
  double nearest = 0.5;
  double typical_distance = 2.5;
  double least_correlation = 0.8;
  double least_gradient = 3.0;
  int spacing = 20;
  double largest_search = 200.0;
  double largest_view_change = 0.6;
  double largest_linearity_index = 0.1;
  double systematic_share = 0.5;

  void describe(Fields& fields);
};

/// @throw ConfigError
void requireUsable(const MonoEkfConfig& config);

}  // namespace slam::mono_ekf
