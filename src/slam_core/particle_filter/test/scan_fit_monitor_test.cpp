// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_fit_monitor.hpp"

#include <gtest/gtest.h>

#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::particle_filter {
namespace {

/// The share of contradicting ends of a scan that a robot took elsewhere, once the room is mapped.
double shareElsewhere(const grid_map::GridMapConfig& config, const Pose2& elsewhere) {
  const grid_map::BeamModel model(config);
  grid_map::GridMap::Memory memory;
  grid_map::GridMap map(memory);
  test::RoomDrive drive(1);
  test::RoomDrive::Step step;
  for (int i = 0; i < 145; ++i) {
    step = drive.next();
    insertScan(model, pointsOf(step.scan, model, 0.05), step.truth, map);
  }
  ScanFitMonitor monitor(model);
  monitor.judge(map, pointsOf(step.scan, model, 0.05), step.truth * elsewhere);
  EXPECT_EQ(monitor.isLost(), monitor.contradictingShare() > 0.5);
  return monitor.contradictingShare();
}

TEST(ScanFitMonitor, KnowsWhatContradictsTheMapHoweverLittleACellIsBelieved) {
  for (const double miss : {0.3, 0.4, 0.49})
    for (const double largest : {0.6, 0.7, 0.72, 0.97}) {
      grid_map::GridMapConfig config;
      config.miss_probability = miss;
      config.largest_probability = largest;
      EXPECT_LT(shareElsewhere(config, Pose2()), 0.05) << miss << " " << largest;
      EXPECT_GT(shareElsewhere(config, Pose2(0, 0, 0.7)), 0.5) << miss << " " << largest;
    }
}

}  // namespace
}  // namespace slam::particle_filter
