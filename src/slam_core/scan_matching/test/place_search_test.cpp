// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/place_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam_core/grid_map/beam_reading.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::scan_matching {
namespace {

using grid_map::GridMap;
using grid_map::ScanPoints;
using grid_map::Tile;

/// A map of the room from known poses.
class PlaceSearchInARoom : public testing::Test {
 protected:
  PlaceSearchInARoom() {
    for (int i = 0; i < test::RoomDrive::kLap; ++i) {
      const auto step = drive.next();
      insertScan(model, pointsOf(step.scan, model, 0.1), step.truth, map);
    }
    const auto step = drive.next();
    scan = pointsOf(step.scan, model, 0.1);  // one that is not in the map
    truth = step.truth;
  }

  /// The logarithm of the likelihood of the scan from there, times a Gaussian about the middle.
  double logAt(const Pose2& pose, const Pose2& middle, const SearchWindow& window) const {
    const Pose2 error = middle.between(pose);
    double sum = -0.5 * (std::pow(error.position().norm() / window.position, 2) +
                         std::pow(error.theta() / window.heading, 2));
    for (const auto& end : scan.ends) {
      const auto cell = grid_map::cellOf(scan.inCells(pose).transform(end));
      const auto* const tile = map.tile(cell);
      const double likelihood = tile == nullptr ? 0.0 : tile->likelihood[Tile::at(cell)] / 255.0;
      sum += std::log((likelihood + 0.05) / 1.05);
    }
    return sum;
  }

  grid_map::BeamModel model;
  GridMap::Memory memory;
  GridMap map{memory};
  test::RoomDrive drive{3};
  ScanPoints scan;
  Pose2 truth;
};

TEST_F(PlaceSearchInARoom, FindsTheScanFromFarOff) {
  for (const auto& offset : {Pose2(0.9, -0.8, 0.5), Pose2(-1.1, 1.1, -1.5), Pose2()}) {
    const PlaceSearch search(map, scan, truth * offset, {1.2, 1.6});
    const auto found = search.best();
    ASSERT_TRUE(found);
    EXPECT_LT((found->position() - truth.position()).norm(), 0.06);
    EXPECT_LT(std::abs(truth.between(*found).theta()), 0.02);
  }
}

TEST_F(PlaceSearchInARoom, NothingOnTheLatticeIsBetterThanTheBest) {
  const SearchWindow window{0.3, 0.1};
  const Pose2 middle = truth * Pose2(0.5, 0.4, 0.3);  // the truth is not in the window
  const auto found = PlaceSearch(map, scan, middle, window).best();
  ASSERT_TRUE(found);
  const double best = logAt(*found, middle, window);
  constexpr double kCell = 0.05, kHeading = 0.005, kRounding = 0.2;
  for (int x = -6; x <= 6; ++x)
    for (int y = -6; y <= 6; ++y)
      for (int turn = -10; turn <= 10; ++turn) {
        const Pose2 pose(middle.x() + kCell * x, middle.y() + kCell * y,
                         middle.theta() + kHeading * turn);
        ASSERT_LE(logAt(pose, middle, window), best + kRounding) << x << " " << y << " " << turn;
      }
}

TEST_F(PlaceSearchInARoom, TheBestApartFromAPlaceLiesThere) {
  const SearchWindow window{1.0, 0.5}, apart{0.4, 0.2};
  const PlaceSearch search(map, scan, truth, window);
  const auto first = search.best(), second = search.bestApartFrom(*first, apart);
  ASSERT_TRUE(second);
  const Pose2 error = first->between(*second);
  EXPECT_TRUE(error.position().norm() > 0.4 || std::abs(error.theta()) > 0.2);
  EXPECT_LT(logAt(*second, truth, window), logAt(*first, truth, window));
  EXPECT_FALSE(search.bestApartFrom(*first, {10.0, 4.0})) << "nothing in the window is so far off";
}

TEST_F(PlaceSearchInARoom, WithoutEndsOrAPlaceOnTheMapNothingIsFound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, 1e300, -1e15})
    EXPECT_FALSE(PlaceSearch(map, scan, Pose2(x, 0, 0), {0.4, 0.4}).best());
  scan.ends.clear();
  EXPECT_FALSE(PlaceSearch(map, scan, truth, {0.4, 0.4}).best());
}

TEST_F(PlaceSearchInARoom, AWindowWithoutAnExtentHoldsItsMiddle) {
  const auto found = PlaceSearch(map, scan, truth, {0.0, 0.0}).best();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->vector(), truth.vector());
}

TEST_F(PlaceSearchInARoom, APyramidIsNowhereBelowACellThatAShiftLeadsTo) {
  const grid_map::CellIndex least{-90, -20}, most{120, 130};
  const LikelihoodPyramid pyramid(map, least, most, 5);
  RandomStream random(2, 0);
  const auto below = [&](std::int32_t n) {
    return static_cast<std::int32_t>(random.uniform() * n);
  };
  for (int i = 0; i < 20000; ++i) {
    const int level = below(pyramid.levels());
    const auto edge = 1 << level;
    const grid_map::CellIndex cell{least.x + below(most.x - edge - least.x),
                                   least.y + below(most.y - edge - least.y)};
    const grid_map::CellIndex shifted{cell.x + below(edge), cell.y + below(edge)};
    const auto* const tile = map.tile(shifted);
    if (tile == nullptr) continue;
    ASSERT_GE(pyramid.level(level)[pyramid.at(cell)], tile->likelihood[Tile::at(shifted)]);
  }
}

TEST_F(PlaceSearchInARoom, FindsNothingWhereItsRastersWouldNotFitIntoMemory) {
  constexpr SearchWindow kWindow{1.0, 0.3};
  ASSERT_TRUE(PlaceSearch(map, scan, truth, kWindow).best());
  scan.ends.emplace_back(5000.0, 0.0);  // [cells]
  const PlaceSearch search(map, scan, truth, kWindow);
  EXPECT_FALSE(PlaceSearch::isWithinMemory(scan, kWindow));
  EXPECT_FALSE(search.isWithinReach());
  EXPECT_FALSE(search.best());
}

}  // namespace
}  // namespace slam::scan_matching
