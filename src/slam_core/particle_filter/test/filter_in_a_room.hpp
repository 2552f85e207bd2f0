// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::particle_filter {

using test::RoomDrive;

constexpr int kLap = 145;  // steps

inline PfConfig gridConfig() {
  PfConfig config;
  config.particles = 15;
  config.resampling_threshold = 0.5;
  return config;
}

inline std::unique_ptr<FastSlam> made(const PfConfig& config = gridConfig(),
                                      const ScanConfig& scan = {},
                                      const grid_map::GridMapConfig& grid = {}) {
  auto filter = std::make_unique<FastSlam>();
  as<MapChooser>(*filter).useMap(MapKind::kGrid);
  filter->configure(config, grid, scan);
  return filter;
}

inline Status take(FastSlam& filter, const RoomDrive::Step& step) {
  give(step.motion, filter);
  give(step.scan, filter);
  return filter.execute();
}

/// @return the largest distance between pose and truth [m]
inline double run(FastSlam& filter, RoomDrive& drive, int steps) {
  double worst = 0.0;
  for (int i = 0; i < steps; ++i) {
    const auto step = drive.next();
    EXPECT_EQ(take(filter, step).message, "");
    worst = std::max(worst, (filter.pose().pose.position() - step.truth.position()).norm());
  }
  return worst;
}

}  // namespace slam::particle_filter
