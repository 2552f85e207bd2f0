// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam::mono_graph {

struct MonoGraphConfig {
  static constexpr const char* kSection = "mono_graph";

  BackendMode mode = BackendMode::kSlam;
  int features = 1000;
  double sigma = 0.8;
  double keyframe_distance = 0.25;
  double keyframe_turn = 0.25;
  int window = 12;
  int least_points = 15;
  int most_keyframes = 5000;
  int least_place_points = 30;
  double least_similarity = 0.04;
  std::string vocabulary;

  void describe(Fields& fields);
};

/// @throw ConfigError
void requireUsable(const MonoGraphConfig& config);

}  // namespace slam::mono_graph
