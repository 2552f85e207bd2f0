// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::ceiling_features {

struct CeilingFeaturesConfig {
  static constexpr const char* kSection = "ceiling_features";

  double size = 0.03;
  double spacing = 0.3;
  double min_contrast = 0.1;
  double min_range = 0.25;
  int max_features = 15;
  double pixel_sigma = 0.3;
  double relative_sigma = 0.003;

  void describe(Fields& fields);
};

}  // namespace slam::ceiling_features
