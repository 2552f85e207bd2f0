// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::rat {

struct PoseCellConfig {
  static constexpr const char* kSection = "pose_cells";

  int edge = 24;
  int headings = 36;
  double cell_size = 0.25;
  double excitation_sigma = 1.0;
  double inhibition_sigma = 2.0;
  double global_inhibition = 2e-4;
  double injected = 0.05;
  double fading = 1.0;
  double recovery = 0.05;

  void describe(Fields& fields);
};

/// @throw ConfigError
void requireUsable(const PoseCellConfig& config);

}  // namespace slam::rat
