// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::rat {

struct LocalViewConfig {
  static constexpr const char* kSection = "local_view";

  int columns = 48, rows = 24;
  double crop_top = 0.125;
  double crop_bottom = 0.2;
  int largest_shift = 3;
  double largest_difference = 0.25;
  double least_contrast = 4.0;
  int most_views = 10000;

  void describe(Fields& fields);
};

/// @throw ConfigError
void requireUsable(const LocalViewConfig& config);

}  // namespace slam::rat
