// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam::point_map {

/// The component's settings.
struct PointMapConfig {
  static constexpr const char* kSection = "point_map";

  enum class Fusion { kEuclidean, kAligned };

  Fusion fusion = Fusion::kEuclidean;
  double fusion_distance = 0.05;
  std::uint64_t max_points = 1000000;
  double alignment_distance = 0.3;
  double alignment_share = 0.5;
  double surface_distance = 0.15;
  double prior_sigma_position = 0.1;
  double prior_sigma_heading = 0.05;

  void describe(Fields& fields);
};

}  // namespace slam::point_map
