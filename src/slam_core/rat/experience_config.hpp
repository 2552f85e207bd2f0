// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam::rat {

struct ExperienceConfig {
  static constexpr const char* kSection = "rat";

  BackendMode mode = BackendMode::kSlam;
  double largest_distance = 1.5;
  int relaxations = 20;
  double correction = 0.5;
  int most_experiences = 50000;
  int most_steps = 500000;

  void describe(Fields& fields);
};

/// @throw ConfigError
void requireUsable(const ExperienceConfig& config);

}  // namespace slam::rat
