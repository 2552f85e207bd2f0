// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/product/test/driven_backend.hpp"

// What a back-end promises that makes an occupancy grid. It is driven by motion and a laser's
// scans.

namespace slam::test {

class GridContract : public ContractTest {
 protected:
  static constexpr int kLap = 145;

  static void take(DrivenBackend& backend, RoomDrive& drive) {
    const auto step = drive.next();
    backend.inputs().offer(step.motion);
    backend.inputs().set(step.scan);
    backend.execute();
  }
  static std::vector<std::int8_t> cellsOf(const DrivenBackend& backend) {
    const auto grid = backend.as<GridMapper>().grid();
    return grid ? grid->cells : std::vector<std::int8_t>();
  }
  static std::uint64_t revisionOf(const DrivenBackend& backend) {
    return backend.as<GridMapper>().gridRevision();
  }
};
// A back-end that makes no grid has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GridContract);

TEST_P(GridContract, HasTheWallsOfARoom) {
  auto backend = make();
  EXPECT_TRUE(cellsOf(backend).empty()) << "nothing before the first scan";
  RoomDrive drive(1);
  for (int i = 0; i < kLap; ++i) take(backend, drive);
  const auto grid = backend.as<GridMapper>().grid();
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->cells.size(), std::size_t{grid->width} * grid->height);
  EXPECT_GT(shareOnWalls(*grid, drive.room()), 0.75);
}

TEST_P(GridContract, ItsRevisionGrowsWheneverItHasChanged) {
  auto backend = make();
  RoomDrive drive(2);
  int changes = 0;
  for (int i = 0; i < 40; ++i) {
    const auto cells = cellsOf(backend);
    const auto revision = revisionOf(backend);
    take(backend, drive);
    ASSERT_GE(revisionOf(backend), revision);
    if (cellsOf(backend) == cells) continue;
    ++changes;
    ASSERT_GT(revisionOf(backend), revision) << "step " << i;
  }
  EXPECT_GT(changes, 0);
  const auto last = revisionOf(backend);
  backend->reset();
  EXPECT_TRUE(cellsOf(backend).empty());
  EXPECT_GT(revisionOf(backend), last) << "a revision is never told twice";
}

TEST_P(GridContract, KeepsTheMapWhenTheRobotIsRedrawn) {
  auto backend = make();
  RoomDrive drive(3);
  for (int i = 0; i < 30; ++i) take(backend, drive);
  const auto cells = cellsOf(backend);
  backend->set(PoseEstimate{Pose2(0.5, 0.2, 0.5), 0.01 * Eigen::Matrix3d::Identity()});
  backend.execute();
  EXPECT_EQ(cellsOf(backend), cells);
}

}  // namespace slam::test
