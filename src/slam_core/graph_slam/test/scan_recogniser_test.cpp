// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_recogniser.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/models/test/simulated_room.hpp"

namespace slam::graph_slam {
namespace {

using test::RoomDrive;

TEST(ScanRecogniser, FindsTheScansOfAnotherDriveAndNeverElsewhere) {
  ScanRecogniser map({}, {});
  RoomDrive first(3);
  for (int i = 0; i < RoomDrive::kLap; ++i) {
    const auto step = first.next();
    if (i % 5 == 0) map.draw(step.scan, step.truth);
  }
  RoomDrive second(4);
  int found = 0;
  constexpr int kScans = 30;
  for (int i = 0; i < 5 * kScans; ++i) {
    const auto step = second.next();
    if (i % 5 != 0) continue;
    const auto match = map.find(step.scan);
    if (!match) continue;
    const Pose2 error = step.truth.between(match->pose);
    EXPECT_LT(error.position().norm(), 0.05) << "step " << i;
    EXPECT_LT(std::abs(error.theta()), 0.02) << "step " << i;
    ++found;
  }
  EXPECT_GT(found, kScans / 2);
}

TEST(ScanRecogniser, DrawsNoMoreThanTheMemoryAllows) {
  grid_map::GridMapConfig small;
  small.largest_memory = 0.01;
  ScanRecogniser map(small, {});
  RoomDrive drive(3);
  const auto step = drive.next();
  map.draw(step.scan, step.truth);
  EXPECT_FALSE(map.find(step.scan));
}

TEST(ScanRecogniser, FindsNothingInAMapWithoutScans) {
  RoomDrive drive(3);
  EXPECT_FALSE(ScanRecogniser({}, {}).find(drive.next().scan));
}

}  // namespace
}  // namespace slam::graph_slam
