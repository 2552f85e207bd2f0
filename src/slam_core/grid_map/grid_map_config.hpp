// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "slam_core/common/config_fields.hpp"

namespace slam::grid_map {

struct GridMapConfig {
  static constexpr const char* kSection = "grid_map";

  double resolution = 0.05;
  double usable_range = 30.0;
  double free_range = 0.0;
  double hit_probability = 0.7;
  double miss_probability = 0.4;
  double largest_probability = 0.97;
  double sigma = 0.05;
  double largest_area = 1e6;
  double largest_memory = 2000.0;

  void describe(Fields& fields);
};

/// Tiles in the rectangle of the largest map. @param config is valid
std::size_t mostTiles(const GridMapConfig& config);
/// Whether maps may be so large.
bool isWithinMemory(double bytes, const GridMapConfig& config);

}  // namespace slam::grid_map
