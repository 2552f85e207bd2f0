// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/explorer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"

namespace slam::active_path {
namespace {

using State = Decision::State;

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

/// Paints the cells of a rectangle, whose corners are given in metres.
void paint(OccupancyGrid& grid, double x0, double y0, double x1, double y1, int percent) {
  const auto cell = [&](double length, double origin) {
    return static_cast<std::uint32_t>(std::lround((length - origin) / grid.resolution));
  };
  for (auto y = cell(y0, grid.origin.y()); y < cell(y1, grid.origin.y()); ++y)
    for (auto x = cell(x0, grid.origin.x()); x < cell(x1, grid.origin.x()); ++x)
      grid.cells[y * grid.width + x] = static_cast<std::int8_t>(percent);
}

OccupancyGrid unknown(double width, double height, double resolution = 0.1) {
  OccupancyGrid grid;
  grid.resolution = resolution;
  grid.width = static_cast<std::uint32_t>(std::lround(width / resolution));
  grid.height = static_cast<std::uint32_t>(std::lround(height / resolution));
  grid.cells.assign(std::size_t{grid.width} * grid.height, OccupancyGrid::kUnknown);
  return grid;
}

/// A corridor along x from 1 m to `length` - 1 m, 2 m wide around y = 2 m, with walls at its sides.
OccupancyGrid corridor(double length, double resolution = 0.1) {
  auto grid = unknown(length, 4.0, resolution);
  paint(grid, 1.0, 0.8, length - 1.0, 3.2, 100);
  paint(grid, 1.0, 1.0, length - 1.0, 3.0, 0);
  return grid;
}

PoseEstimate pose(double x, double y, double sigma = 0.02) {
  PoseEstimate estimate;
  estimate.pose = {x, y, 0.0};
  estimate.covariance.diagonal() << sigma * sigma, sigma * sigma, 1e-4;
  return estimate;
}

ActivePathConfig config() {
  ActivePathConfig config;
  config.sensor_range = 3.0;
  return config;
}

TEST(Explorer, GoesToTheNearerOfTwoEqualFrontiers) {
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), corridor(12.0), pose(4.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_EQ(decision.state, State::kExploring);
  EXPECT_TRUE(decision.is_new);
  EXPECT_LT(decision.goal->pose.x(), 1.5);
  EXPECT_GT(std::abs(decision.goal->pose.theta()), 2.8) << "it looks into the unknown";
  EXPECT_GT(decision.candidates.size(), 1U);
}

TEST(Explorer, StandsBackFromTheUnknownByItsRadius) {
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), corridor(12.0), pose(4.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_GE(decision.goal->pose.x(), 1.0 + config().robot_radius);
}

TEST(Explorer, GoesFartherWhereMoreIsGainedPerMetre) {
  auto map = corridor(12.0);
  paint(map, 0.4, 1.0, 0.5, 3.0, 100);  // little is left to see in the west
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), map, pose(5.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_GT(decision.goal->pose.x(), 10.0);
}

TEST(Explorer, TheWayLeadsThroughFreeCellsAndKeepsTheRadius) {
  auto map = corridor(12.0);
  paint(map, 5.0, 1.0, 5.3, 2.0, 100);  // half of the corridor
  paint(map, 0.6, 0.8, 1.0, 3.2, 100);  // its west end
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), map, pose(3.0, 1.5));
  ASSERT_TRUE(decision.goal);
  const FreeSpace space(map, config().robot_radius);
  ASSERT_GT(decision.way.size(), 50U);
  EXPECT_LT((decision.way.front() - Eigen::Vector2d(3.0, 1.5)).norm(), 0.15);
  EXPECT_EQ(decision.way.back(), decision.goal->pose.position());
  for (std::size_t i = 0; i < decision.way.size(); ++i) {
    EXPECT_TRUE(space.isPassable(space.cellAt(decision.way[i])));
    if (i > 0) {
      EXPECT_LT((decision.way[i] - decision.way[i - 1]).norm(), 0.15);
    }
  }
}

/// Two rooms, of which the left one is closed but for a door of `door` [m] to the right one, which
/// is open in the east.
OccupancyGrid twoRooms(double door, double resolution = 0.05) {
  auto map = unknown(10.0, 5.0, resolution);
  paint(map, 0.8, 0.8, 8.0, 4.2, 100);
  paint(map, 1.0, 1.0, 4.0, 4.0, 0);
  paint(map, 4.2, 1.0, 8.0, 4.0, 0);
  paint(map, 4.0, 2.5 - 0.5 * door, 4.2, 2.5 + 0.5 * door, 0);
  return map;
}

TEST(Explorer, AFrontierBehindAWallIsNoGoal) {
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), twoRooms(0.0), pose(2.0, 2.0));
  EXPECT_FALSE(decision.goal);
  EXPECT_EQ(decision.state, State::kExplored);
}

TEST(Explorer, ADoorIsPassedOnlyWhereTheRobotFitsThrough) {
  Explorer narrow(config()), wide(config());
  EXPECT_EQ(narrow.decide(at(0), twoRooms(0.4), pose(2.0, 2.0)).state, State::kExplored);
  const auto decision = wide.decide(at(0), twoRooms(0.6), pose(2.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_GT(decision.goal->pose.x(), 7.0);
}

TEST(Explorer, KeepsAGoalUntilAnotherIsClearlyBetter) {
  Explorer explorer(config());
  const auto map = corridor(12.0);
  const auto west = explorer.decide(at(0), map, pose(5.8, 2.0));
  ASSERT_TRUE(west.goal);
  EXPECT_LT(west.goal->pose.x(), 2.0);
  const auto kept = explorer.decide(at(1), map, pose(6.3, 2.0));  // the east is nearer by now
  ASSERT_TRUE(kept.goal);
  EXPECT_FALSE(kept.is_new);
  EXPECT_EQ(kept.goal->pose.x(), west.goal->pose.x());
  const auto east = explorer.decide(at(2), map, pose(8.5, 2.0));
  ASSERT_TRUE(east.goal);
  EXPECT_TRUE(east.is_new);
  EXPECT_GT(east.goal->pose.x(), 10.0);
}

TEST(Explorer, GivesAGoalUpThatShowsNothingNew) {
  Explorer explorer(config());
  auto map = corridor(12.0);
  explorer.decide(at(0), map, pose(4.0, 2.0));
  paint(map, 0.0, 0.8, 1.0, 3.2, 100);
  paint(map, 0.8, 1.0, 1.0, 3.0, 0);
  const auto decision = explorer.decide(at(1), map, pose(4.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_GT(decision.goal->pose.x(), 10.0);
  EXPECT_EQ(explorer.counters()["goal_seen"], 1U);
}

TEST(Explorer, GivesAGoalUpThatCannotBeReachedAnyMore) {
  Explorer explorer(config());
  auto map = corridor(12.0);
  explorer.decide(at(0), map, pose(4.0, 2.0));
  paint(map, 2.5, 0.8, 2.7, 3.2, 100);
  const auto decision = explorer.decide(at(1), map, pose(4.0, 2.0));
  ASSERT_TRUE(decision.goal);
  EXPECT_GT(decision.goal->pose.x(), 10.0);
  EXPECT_EQ(explorer.counters()["goal_unreachable"], 1U);
}

TEST(Explorer, AGoalThatIsNotReachedIsLeftOutForAWhileAndToldOnce) {
  auto settings = config();
  settings.goal_timeout = 10.0;
  settings.left_out_time = 100.0;
  Explorer explorer(settings);
  const auto map = corridor(12.0);
  const auto first = explorer.decide(at(0), map, pose(4.0, 2.0));
  EXPECT_TRUE(explorer.decide(at(9), map, pose(4.0, 2.0)).status.isOk());
  const auto other = explorer.decide(at(11), map, pose(4.0, 2.0));
  EXPECT_NE(other.status.message.find("has come no nearer to the goal"), std::string::npos);
  ASSERT_TRUE(other.goal);
  EXPECT_GT((other.goal->pose.position() - first.goal->pose.position()).norm(), 0.3);
  EXPECT_TRUE(explorer.decide(at(12), map, pose(4.0, 2.0)).status.isOk());
  EXPECT_EQ(explorer.counters()["goal_not_reached"], 1U);
}

TEST(Explorer, AGoalThatComesNearerHasTime) {
  auto settings = config();
  settings.goal_timeout = 10.0;
  Explorer explorer(settings);
  const auto map = corridor(30.0);
  for (int second = 0; second < 40; ++second)
    EXPECT_TRUE(explorer.decide(at(second), map, pose(14.0 - 0.3 * second, 2.0)).status.isOk());
  EXPECT_EQ(explorer.counters()["goal_not_reached"], 0U);
}

TEST(Explorer, WaitsForWhatIsLeftOutAndEndsWhenItIsLeftOutAgain) {
  auto settings = config();
  settings.goal_timeout = 10.0;
  settings.left_out_time = 100.0;
  settings.left_out_radius = 10.0;
  Explorer explorer(settings);
  auto map = corridor(12.0);
  paint(map, 11.0, 0.8, 11.2, 3.2, 100);
  const auto here = pose(5.0, 2.0);
  ASSERT_TRUE(explorer.decide(at(0), map, here).goal);
  EXPECT_EQ(explorer.decide(at(11), map, here).state, State::kWaiting);
  EXPECT_EQ(explorer.decide(at(110), map, here).state, State::kWaiting);
  EXPECT_TRUE(explorer.decide(at(112), map, here).goal);
  EXPECT_EQ(explorer.decide(at(123), map, here).state, State::kExplored);
}

TEST(Explorer, AViewpointThatWasReachedIsNotChosenAgain) {
  Explorer explorer(config());
  const auto map = corridor(12.0);  // the unknown stays unknown, as behind glass
  PoseEstimate here = pose(4.0, 2.0);
  int second = 0;
  for (; second < 100; ++second) {
    const auto decision = explorer.decide(at(second), map, here);
    if (decision.state == State::kExplored) break;
    ASSERT_TRUE(decision.goal);
    here.pose = decision.goal->pose;
  }
  EXPECT_LT(second, 50);
  EXPECT_FALSE(explorer.decide(at(second + 1), map, here).goal);
  explorer.resume();
  EXPECT_TRUE(explorer.decide(at(second + 2), map, here).goal);
}

/// The robot drives along the corridor, and its position becomes uncertain at `x`.
Decision driveUntil(Explorer& explorer, const OccupancyGrid& map, double x, double sigma) {
  int second = 0;
  for (double place = 2.0; place < x; place += 0.4)
    explorer.decide(at(second++), map, pose(place, 2.0));
  return explorer.decide(at(second), map, pose(x, 2.0, sigma));
}

TEST(Explorer, GoesBackToAPlaceThatItKnowsWhenUncertain) {
  Explorer explorer(config());
  const auto map = corridor(16.0);
  const auto decision = driveUntil(explorer, map, 10.0, 0.4);
  EXPECT_EQ(decision.state, State::kClosingLoop);
  ASSERT_TRUE(decision.goal);
  EXPECT_TRUE(decision.goal->closes_loop);
  EXPECT_LT(decision.goal->pose.x(), 7.1) << "left by the loop distance";
  EXPECT_GT(decision.goal->pose.x(), 5.9) << "but no farther than needed";
  const auto still = explorer.decide(at(100), map, pose(9.0, 2.0, 0.2));
  EXPECT_EQ(still.state, State::kClosingLoop) << "not below half of the bound";
  const auto certain = explorer.decide(at(101), map, pose(8.0, 2.0, 0.1));
  EXPECT_EQ(certain.state, State::kExploring);
  ASSERT_TRUE(certain.goal);
  EXPECT_FALSE(certain.goal->closes_loop);
}

TEST(Explorer, DoesNotGoToAndFroWhereGoingBackDoesNotHelp) {
  Explorer explorer(config());
  const auto map = corridor(16.0);
  ASSERT_EQ(driveUntil(explorer, map, 10.0, 0.4).state, State::kClosingLoop);
  ASSERT_EQ(explorer.decide(at(100), map, pose(7.0, 2.0, 0.1)).state, State::kExploring);
  EXPECT_EQ(explorer.decide(at(110), map, pose(10.0, 2.0, 0.4)).state, State::kExploring);
  EXPECT_EQ(explorer.decide(at(120), map, pose(12.0, 2.0, 0.5)).state, State::kClosingLoop);
}

TEST(Explorer, ExploresOnWhereNoPlaceIsKnown) {
  Explorer explorer(config());
  const auto decision = explorer.decide(at(0), corridor(12.0), pose(4.0, 2.0, 1.0));
  EXPECT_TRUE(decision.goal);
  EXPECT_NE(decision.status.message.find("exploring on"), std::string::npos);
}

TEST(Explorer, WaitsForAMapThatCanBeUsed) {
  const auto told = [](const OccupancyGrid& map, const std::string& words) {
    Explorer explorer(config());
    const auto decision = explorer.decide(at(0), map, pose(1.0, 1.0));
    EXPECT_EQ(decision.state, State::kWaiting);
    EXPECT_FALSE(decision.goal);
    EXPECT_NE(decision.status.message.find(words), std::string::npos) << decision.status.message;
  };
  told(OccupancyGrid(), "it has no cells");
  told(unknown(4.0, 4.0), "outside of the map's known free space");
  auto map = corridor(12.0);
  map.cells.pop_back();
  told(map, "do not fill");
  map = corridor(12.0);
  map.resolution = std::numeric_limits<double>::quiet_NaN();
  told(map, "resolution");
  map = corridor(12.0);
  map.origin.x() = std::numeric_limits<double>::infinity();
  told(map, "origin");
}

TEST(Explorer, WaitsForAPoseThatCanBeUsed) {
  const auto told = [](const PoseEstimate& estimate, const std::string& words) {
    Explorer explorer(config());
    auto map = corridor(12.0);
    paint(map, 5.0, 1.0, 7.0, 3.0, 100);
    const auto decision = explorer.decide(at(0), map, estimate);
    EXPECT_EQ(decision.state, State::kWaiting);
    EXPECT_NE(decision.status.message.find(words), std::string::npos) << decision.status.message;
  };
  told(pose(std::nan(""), 1.0), "not a number");
  told(pose(2.0, 2.0, std::nan("")), "covariance");
  told(pose(-50.0, 2.0), "outside of the map");
  told(pose(1e300, 2.0), "outside of the map");
  told(pose(6.0, 2.0), "within 0.25 m of an obstacle");
}

TEST(Explorer, BeginsBesideAWallOrInTheBlindZoneOfTheLaser) {
  Explorer explorer(config());
  auto map = corridor(12.0);
  EXPECT_TRUE(explorer.decide(at(0), map, pose(4.0, 1.05)).goal) << "too near to the wall";
  paint(map, 3.8, 1.9, 4.2, 2.1, OccupancyGrid::kUnknown);
  EXPECT_TRUE(explorer.decide(at(1), map, pose(4.0, 2.0)).goal);
}

TEST(Explorer, KeepsItsGoalWhenTheMapGrowsOrHasAnotherResolution) {
  Explorer explorer(config());
  const auto first = explorer.decide(at(0), corridor(12.0), pose(4.0, 2.0));
  ASSERT_TRUE(first.goal);
  auto grown = unknown(20.0, 10.0, 0.05);
  grown.origin = {-4.0, -3.0};
  paint(grown, 1.0, 0.8, 11.0, 3.2, 100);
  paint(grown, 1.0, 1.0, 11.0, 3.0, 0);
  const auto second = explorer.decide(at(1), grown, pose(3.8, 2.0));
  ASSERT_TRUE(second.goal);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(second.goal->pose.position(), first.goal->pose.position());
  EXPECT_NEAR(second.goal->gain, first.goal->gain, 0.3 * first.goal->gain);
}

TEST(Explorer, StartsOverWhenTimeGoesBack) {
  Explorer explorer(config());
  const auto map = twoRooms(0.0);
  EXPECT_EQ(explorer.decide(at(100), map, pose(2.0, 2.0)).state, State::kExplored);
  EXPECT_TRUE(explorer.decide(at(0), corridor(12.0), pose(4.0, 2.0)).goal);
}

TEST(Explorer, RefusesSettingsOutOfTheirRange) {
  auto settings = config();
  settings.robot_radius = -1.0;
  EXPECT_THROW(Explorer{settings}, ConfigError);
}

}  // namespace
}  // namespace slam::active_path
