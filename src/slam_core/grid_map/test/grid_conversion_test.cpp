// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_conversion.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace slam::grid_map {
namespace {

constexpr auto kUnknown = OccupancyGrid::kUnknown;

OccupancyGrid smallGrid() {
  OccupancyGrid grid;
  grid.resolution = 0.05;
  grid.origin = {-0.1, 1.0};
  grid.width = 3;
  grid.height = 2;
  grid.cells = {0, 100, kUnknown, 0, 0, 100};
  return grid;
}

class GridConversion : public testing::Test {
 protected:
  BeamModel model;
  GridMap::Memory memory;
  GridMap map{memory};
};

TEST_F(GridConversion, ShowsNothingOfAnEmptyMap) {
  const auto grid = occupancyGridOf(map, 0.05);
  EXPECT_EQ(grid.width * grid.height, 0u);
  EXPECT_TRUE(grid.cells.empty());
  EXPECT_EQ(entropyOf(map), 0.0);
}

TEST_F(GridConversion, ShowsWhatItWasFilledFrom) {
  EXPECT_TRUE(fillFrom(smallGrid(), model, map).isOk());
  const auto grid = occupancyGridOf(map, 0.05);
  EXPECT_EQ(grid.resolution, 0.05);
  EXPECT_LT((grid.origin - smallGrid().origin).norm(), 1e-12);
  ASSERT_EQ(grid.width, 3u);
  ASSERT_EQ(grid.height, 2u);
  EXPECT_EQ(grid.cells, (std::vector<std::int8_t>{3, 97, kUnknown, 3, 3, 97}))
      << "as sure as a cell may be";
}

TEST_F(GridConversion, TakesACoarserAndAFinerGrid) {
  auto coarse = smallGrid();
  coarse.resolution = 0.1;
  EXPECT_TRUE(fillFrom(coarse, model, map).isOk());
  const auto shown = occupancyGridOf(map, 0.05);
  EXPECT_EQ(shown.width, 6u);
  EXPECT_EQ(shown.cells[2], 97);
  EXPECT_EQ(shown.cells[3], 97);
  EXPECT_EQ(shown.cells[4], kUnknown);

  GridMap other(memory);
  auto fine = smallGrid();
  fine.resolution = 0.02;
  EXPECT_TRUE(fillFrom(fine, model, other).isOk());
  const auto coarser = occupancyGridOf(other, 0.05);
  EXPECT_EQ(coarser.width, 2u) << "6 cm from a cell's border on";
  EXPECT_EQ(coarser.cells[0], 97) << "the most likely of those that it touches";
}

TEST_F(GridConversion, MatchesBeamsWithTheMiddleOfWhatIsOccupied) {
  ASSERT_TRUE(fillFrom(smallGrid(), model, map).isOk());
  const CellIndex occupied{-1, 20};
  EXPECT_EQ(map.tile(occupied)->likelihood[Tile::at(occupied)], 255);
}

TEST_F(GridConversion, RefusesWhatIsNoMap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto grid = smallGrid();
  grid.resolution = 0.0;
  EXPECT_EQ(fillFrom(grid, model, map).level, Status::Level::kError);
  grid.resolution = nan;
  EXPECT_EQ(fillFrom(grid, model, map).level, Status::Level::kError);
  grid = smallGrid();
  grid.origin.x() = nan;
  EXPECT_EQ(fillFrom(grid, model, map).level, Status::Level::kError);
  grid.origin.x() = 1e30;
  EXPECT_EQ(fillFrom(grid, model, map).level, Status::Level::kError);
  grid = smallGrid();
  grid.cells.pop_back();
  EXPECT_EQ(fillFrom(grid, model, map).level, Status::Level::kError);
  EXPECT_TRUE(map.isEmpty());
}

TEST_F(GridConversion, TellsWhatHasNoRoom) {
  GridMap::Memory small(1);
  map = GridMap(small);
  auto grid = smallGrid();
  grid.origin = {0.0, 0.0};
  grid.resolution = 1.0;
  const auto status = fillFrom(grid, model, map);
  EXPECT_EQ(status.level, Status::Level::kWarning) << "what has room is used";
  EXPECT_NE(status.message.find("largest_area"), std::string::npos) << status.message;
  map = GridMap(memory);
}

TEST_F(GridConversion, HasTheEntropyOfItsCells) {
  ASSERT_TRUE(fillFrom(smallGrid(), model, map).isOk());
  const double p = 1.0 / (1.0 + std::exp(model.largestLogOdds() / kLogOddsUnit));
  const double of_one = -p * std::log2(p) - (1 - p) * std::log2(1 - p);
  EXPECT_NEAR(entropyOf(map), 5.0 * of_one, 1e-9);
  map.ownTile({50, 50})->log_odds[Tile::at({50, 50})] = 0;
  EXPECT_NEAR(entropyOf(map), 5.0 * of_one + 1.0, 1e-9) << "of which nothing is known: a bit";
}

}  // namespace
}  // namespace slam::grid_map
