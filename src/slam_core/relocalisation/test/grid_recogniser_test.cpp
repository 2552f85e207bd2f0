// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/grid_recogniser.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::relocalisation {
namespace {

using slam::test::RoomDrive;
using Verdict = Recognition::Verdict;

/// The grid of a lap in the room, drawn from the true poses.
OccupancyGrid gridOf(RoomDrive drive, const grid_map::GridMapConfig& config) {
  scan_matching::ScanMap map(config);
  const auto models = scan_matching::levelModels(config);
  for (int i = 0; i < 150; ++i) {
    const auto step = drive.next();
    map.insert(scan_matching::pointsOf(step.scan, models, 0.02), step.truth);
  }
  return occupancyGridOf(map.finest().map, map.finest().model.resolution());
}

class GridRecogniserTest : public testing::Test {
 protected:
  /// Drives on until a place is confirmed, for so many steps at most.
  Verdict drive(int steps) {
    Verdict verdict = Verdict::kNothing;
    for (int i = 0; i < steps && verdict != Verdict::kConfirmed; ++i) {
      const auto step = robot.next();
      truth = step.truth;
      recogniser.move(step.motion);
      recogniser.see(step.scan);
      if (const auto found = recogniser.find()) {
        last = *found;
        verdict = found->verdict;
        ++searches;
      }
    }
    return verdict;
  }

  /// Tests the place on that is so far from the truth, for so many steps at most.
  GridRecogniser::Test test(int steps, const Pose2& shift) {
    recogniser.beginTest();
    auto result = GridRecogniser::Test::kGoesOn;
    for (int i = 0; i < steps && result == GridRecogniser::Test::kGoesOn; ++i) {
      const auto step = robot.next();
      recogniser.move(step.motion);
      recogniser.see(step.scan);
      result = recogniser.test(shift * step.truth);
    }
    return result;
  }

  grid_map::GridMapConfig config;
  RoomDrive robot{2};
  GridRecogniser recogniser{{}, config, {}};
  Recognition last;
  Pose2 truth;
  int searches = 0;
};

TEST_F(GridRecogniserTest, FindsTheRobotAfterAMetreOrTwo) {
  const auto grid = gridOf(RoomDrive(1), config);
  for (int i = 0; i < 70; ++i) robot.next();  // half round the box
  recogniser.begin(grid);
  ASSERT_EQ(drive(25), Verdict::kConfirmed);
  EXPECT_LT((last.robot.pose.position() - truth.position()).norm(), 0.1);
  EXPECT_LT(std::abs(wrapAngle(last.robot.pose.theta() - truth.theta())), 0.05);
}

/// More of the room has been moved than the matcher expects.
TEST_F(GridRecogniserTest, FindsTheRobotWhereSomeWallsHaveGone) {
  auto grid = gridOf(RoomDrive(1), config);
  constexpr std::size_t kStretch = 20, kEvery = 6;  // [cells]; every sixth stretch is removed
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if ((i % grid.width + i / grid.width) / kStretch % kEvery == 0)
      grid.cells[i] = std::min(grid.cells[i], std::int8_t{0});
  for (int i = 0; i < 70; ++i) robot.next();
  recogniser.begin(grid);
  ASSERT_EQ(drive(40), Verdict::kConfirmed);
  EXPECT_LT((last.robot.pose.position() - truth.position()).norm(), 0.1);
}

/// The wheels slip twice on the way.
TEST_F(GridRecogniserTest, FindsTheRobotThoughItsWheelsSlip) {
  recogniser.begin(gridOf(RoomDrive(1), config));
  for (int lurch = 0; lurch < 2; ++lurch) {
    ASSERT_NE(drive(3), Verdict::kConfirmed);
    Motion slip;
    slip.increment = Pose2(0.2, 0.0, 0.25);
    slip.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    recogniser.move(slip);
  }
  ASSERT_EQ(drive(60), Verdict::kConfirmed);
  EXPECT_LT((last.robot.pose.position() - truth.position()).norm(), 0.15);
}

/// Where the scans see nothing that the first search has not seen, nothing is confirmed, however
/// often a search leads there.
TEST_F(GridRecogniserTest, DoesNotConfirmAPlaceBySearchingForTheSameScansAgain) {
  recogniser.begin(gridOf(RoomDrive(1), config));
  robot.way_of_step = 0.0;
  for (int i = 0; i < 20; ++i) {
    recogniser.searchAnyway();
    EXPECT_NE(drive(1), Verdict::kConfirmed);
  }
  EXPECT_EQ(last.verdict, Verdict::kLikely);
}

TEST_F(GridRecogniserTest, NeedsNoConfirmationWhereTheMapWasSaved) {
  recogniser.begin(gridOf(RoomDrive(1), config), Pose2());
  EXPECT_EQ(drive(1), Verdict::kConfirmed);
}

TEST_F(GridRecogniserTest, NeedsConfirmationElsewhereThanWhereTheMapWasSaved) {
  recogniser.begin(gridOf(RoomDrive(1), config), Pose2(2.0, 0.0, 0.0));
  EXPECT_EQ(drive(1), Verdict::kLikely);
}

TEST_F(GridRecogniserTest, AConfirmedPlacePassesTheTestOfTheNextMetres) {
  recogniser.begin(gridOf(RoomDrive(1), config));
  ASSERT_EQ(drive(60), Verdict::kConfirmed);
  EXPECT_EQ(test(150, Pose2()), GridRecogniser::Test::kPassed);
}

TEST_F(GridRecogniserTest, AConfirmedPlaceIsRefutedByScansThatDoNotFit) {
  recogniser.begin(gridOf(RoomDrive(1), config));
  ASSERT_EQ(drive(60), Verdict::kConfirmed);
  EXPECT_EQ(test(30, Pose2(1.5, 0.8, 1.0)), GridRecogniser::Test::kRefuted);
}

TEST_F(GridRecogniserTest, SearchesOnlyAfterSomeOfTheWay) {
  recogniser.begin(gridOf(RoomDrive(1), config));
  robot.way_of_step = 0.0;
  drive(20);
  EXPECT_EQ(searches, 1);
  recogniser.searchAnyway();
  drive(20);
  EXPECT_EQ(searches, 2);
}

TEST_F(GridRecogniserTest, DoesNotChooseBetweenTwoRoomsThatAreAlike) {
  auto one = gridOf(RoomDrive(1), config);
  OccupancyGrid two = one;
  two.width = 2 * one.width;
  two.cells.clear();
  for (std::uint32_t y = 0; y < one.height; ++y)
    for (int copy = 0; copy < 2; ++copy)
      two.cells.insert(two.cells.end(), one.cells.begin() + std::ptrdiff_t{y} * one.width,
                       one.cells.begin() + std::ptrdiff_t{y + 1} * one.width);
  recogniser.begin(two);
  EXPECT_EQ(drive(60), Verdict::kAmbiguous);
  EXPECT_GT(searches, 5);
}

TEST(GridRecogniserLimits, SearchNeitherAnEmptyNorAnEndlessGrid) {
  OccupancyGrid grid;
  grid.resolution = 1.0;
  EXPECT_FALSE(GridRecogniser::canSearch(grid));
  grid.width = grid.height = 400;
  grid.cells.assign(400 * 400, 0);
  EXPECT_TRUE(GridRecogniser::canSearch(grid));
  grid.resolution = 2.0;
  EXPECT_FALSE(GridRecogniser::canSearch(grid));
}

TEST_F(GridRecogniserTest, FindsNothingInTheMapOfAnotherPlace) {
  OccupancyGrid empty;
  empty.resolution = config.resolution;
  empty.width = empty.height = 100;
  empty.cells.assign(100 * 100, 0);
  recogniser.begin(empty);
  EXPECT_EQ(drive(40), Verdict::kNothing);
}

}  // namespace
}  // namespace slam::relocalisation
