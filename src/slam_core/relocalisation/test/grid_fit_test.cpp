// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/grid_fit.hpp"

#include <gtest/gtest.h>

#include "slam_core/relocalisation/test/scan_of_room.hpp"

namespace slam::relocalisation {
namespace {

const test::Room kHall{10.0, 8.0}, kPassage{16.0, 3.0};
const test::CoarseLaser kLaser, kCovered{-M_PI, 180, 0.1};

/// The hall's walls, a cell thick, in a grid that extends a metre beyond them.
OccupancyGrid gridOfHall() {
  OccupancyGrid grid;
  grid.resolution = 0.05;
  grid.origin = {-6.0, -5.0};
  grid.width = 240;
  grid.height = 200;
  grid.cells.assign(240 * 200, OccupancyGrid::kUnknown);
  for (std::uint32_t y = 20; y <= 180; ++y)
    for (std::uint32_t x = 20; x <= 220; ++x)
      grid.cells[y * 240 + x] = x == 20 || x == 220 || y == 20 || y == 180 ? 100 : 0;
  return grid;
}

TEST(GridFit, IsWholeAtThePoseOfTheScan) {
  const Pose2 robot(1.0, 2.0, 0.5);
  EXPECT_DOUBLE_EQ(shareOnSurfaces(gridOfHall(), kLaser.scanOf(kHall, robot), robot), 1.0);
}

TEST(GridFit, RegardsTheMountOfTheLaser) {
  const Pose2 robot(1.0, 2.0, 0.5), mount(0.3, 0.1, M_PI / 2.0);
  auto scan = kLaser.scanOf(kHall, robot * mount);
  scan.sensor_pose = mount;
  EXPECT_DOUBLE_EQ(shareOnSurfaces(gridOfHall(), scan, robot), 1.0);
}

TEST(GridFit, IsTheShareThatNobodyHides) {
  auto scan = kLaser.scanOf(kHall, {});
  for (std::size_t i = 0; i < 45; ++i) scan.beams[i].range = 0.5F;
  EXPECT_DOUBLE_EQ(shareOnSurfaces(gridOfHall(), scan, {}), 0.75);
}

TEST(GridFit, IsSmallElsewhereAndBeyondTheGrid) {
  EXPECT_LT(shareOnSurfaces(gridOfHall(), kLaser.scanOf(kPassage, {}), {}), 0.2);
  EXPECT_EQ(shareOnSurfaces(gridOfHall(), kLaser.scanOf(kHall, {}), {100.0, 0.0, 0.0}), 0.0);
}

TEST(GridFit, CountsEndsNearAWall) {
  for (const auto& [before_wall, share] : {std::pair(0.15, 1.0), std::pair(0.3, 0.0)}) {
    LaserScan scan;
    scan.beams.push_back({0.0F, static_cast<float>(5.0 - before_wall), true});
    EXPECT_EQ(shareOnSurfaces(gridOfHall(), scan, {}), share) << before_wall;
  }
}

TEST(GridFit, IsFoundAfterAPush) {
  const auto scan = kLaser.scanOf(kHall, {0.3, -0.35, 0.3});
  EXPECT_LT(shareOnSurfaces(gridOfHall(), scan, {}), 0.5);
  EXPECT_GT(bestShareOnSurfaces(gridOfHall(), scan, {}), 0.9);
  const auto elsewhere = kLaser.scanOf(kPassage, {});
  EXPECT_LT(bestShareOnSurfaces(gridOfHall(), elsewhere, {}), 0.3);
}

TEST(GridFit, IsZeroIfNothingWasMet) {
  EXPECT_EQ(shareOnSurfaces(gridOfHall(), kCovered.scanOf(kHall, {}), {}), 0.0);
}

}  // namespace
}  // namespace slam::relocalisation
