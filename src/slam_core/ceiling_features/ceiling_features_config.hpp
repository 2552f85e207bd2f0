// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::ceiling_features {

/// Lengths are shares of the ceiling's height above the camera, so that they suit any height: seen
/// from there they are angles.
struct CeilingFeaturesConfig {
  static constexpr const char* kSection = "ceiling_features";

  double size = 0.018;
  double spacing = 0.09;
  double min_contrast = 0.1;
  double min_range = 0.15;
  int max_features = 40;
  double pixel_sigma = 0.3;
  double relative_sigma = 0.003;

  void describe(Fields& fields);
};

}  // namespace slam::ceiling_features
