// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/view_gain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/active_path/ways.hpp"

namespace slam::active_path {
namespace {

OccupancyGrid square(std::uint32_t cells, std::int8_t percent) {
  OccupancyGrid grid;
  grid.resolution = 0.1;
  grid.width = grid.height = cells;
  grid.cells.assign(std::size_t{cells} * cells, percent);
  return grid;
}

constexpr ViewGain::Sensor kSensor{1.0, 2.0 * M_PI, 720, 1e9};

/// What a scan without walls touches: a disc, and of the cells at its edge all.
void expectDisc(double gain) {
  EXPECT_GT(gain, M_PI);
  EXPECT_LT(gain, M_PI * 1.1 * 1.1);
}

TEST(ViewGain, OfTheUnknownIsABitForEachCellInRange) {
  const auto grid = square(41, OccupancyGrid::kUnknown);
  const FreeSpace space(grid, 0.2);
  expectDisc(ViewGain(space, kSensor).at(20 * 41 + 20).gain);
}

TEST(ViewGain, GoesOnBeyondTheGridsEdge) {
  const auto grid = square(3, 0);
  const FreeSpace space(grid, 0.05);
  expectDisc(ViewGain(space, kSensor).at(4).gain + 9 * 0.01);
}

TEST(ViewGain, IsNothingWhereAllIsKnownAndLessWhereItIsHalfKnown) {
  const auto known = square(41, 10), half = square(41, 40), unknown = square(41, 50);
  const auto gainOf = [](const OccupancyGrid& grid) {
    const FreeSpace space(grid, 0.2);
    return ViewGain(space, kSensor).at(20 * 41 + 20).gain;
  };
  EXPECT_EQ(gainOf(known), 0.0);
  EXPECT_NEAR(gainOf(half) / gainOf(unknown), 0.971, 0.001);  // the entropy of 40 % [bit]
}

TEST(ViewGain, BeamsEndAtWallsAndSlipThroughNone) {
  auto grid = square(41, OccupancyGrid::kUnknown);
  for (std::uint32_t i = 0; i < 9; ++i) {  // a diamond of cells that touch by their corners
    const std::uint32_t width = 8 - i;
    for (const std::uint32_t row : {20 + i, 20 - i})
      for (const std::uint32_t column : {20 + width, 20 - width})
        grid.cells[row * 41 + column] = 100;
  }
  const FreeSpace space(grid, 0.2);
  auto sensor = kSensor;
  sensor.range = 3.0;
  EXPECT_LE(ViewGain(space, sensor).at(20 * 41 + 20).gain, (8 * 8 + 7 * 7) * 0.01);
}

TEST(ViewGain, TheUnknownIsExpectedToEndBeams) {
  const auto grid = square(41, OccupancyGrid::kUnknown);
  const FreeSpace space(grid, 0.2);
  auto sensor = kSensor;
  sensor.unknown_way = 0.5;
  const double share = ViewGain(space, sensor).at(20 * 41 + 20).gain /
                       ViewGain(space, kSensor).at(20 * 41 + 20).gain;
  // the integral of 2 pi r exp(-r / 0.5) up to 1 m, by the disc
  EXPECT_NEAR(share, 2.0 * 0.25 * (1.0 - 3.0 * std::exp(-2.0)), 0.03);
}

TEST(ViewGain, LooksWhereMostIsSeen) {
  auto grid = square(41, 0);
  for (std::uint32_t y = 0; y < 41; ++y)
    for (std::uint32_t x = 25; x < 41; ++x) grid.cells[y * 41 + x] = OccupancyGrid::kUnknown;
  const FreeSpace space(grid, 0.2);
  auto sensor = kSensor;
  const auto whole = ViewGain(space, sensor).at(20 * 41 + 20);
  EXPECT_NEAR(whole.heading, 0.0, 0.1);
  sensor.field_of_view = 0.5;
  const auto part = ViewGain(space, sensor).at(20 * 41 + 20);
  EXPECT_NEAR(part.heading, 0.0, 0.3);
  EXPECT_LT(part.gain, 0.5 * whole.gain);
  EXPECT_GT(part.gain, 0.1 * whole.gain);
}

TEST(FreeSpace, ClearanceIsThatOfBruteForce) {
  auto grid = square(23, 0);
  for (const Cell cell : {30U, 31U, 222U, 410U, 500U}) grid.cells[cell] = 100;
  const FreeSpace space(grid, 0.2);
  for (Cell cell = 0; cell < grid.cells.size(); ++cell) {
    double least = 1e9;
    for (Cell other = 0; other < grid.cells.size(); ++other)
      if (grid.cells[other] == 100)
        least = std::min(least, (space.centre(cell) - space.centre(other)).norm());
    EXPECT_NEAR(space.clearance(cell), least - 0.05, 1e-5);
  }
}

TEST(Ways, AreAsLongAsTheyMustBe) {
  const auto grid = square(60, 0);
  const FreeSpace space(grid, 0.2);
  const Ways ways(space, 10 * 60 + 10, 0.2);
  EXPECT_NEAR(ways.cost(10 * 60 + 40), 3.0, 1e-4);
  EXPECT_NEAR(ways.cost(40 * 60 + 40), 3.0 * std::sqrt(2.0), 1e-4);
  EXPECT_EQ(ways.to(10 * 60 + 10).size(), 1U);
}

}  // namespace
}  // namespace slam::active_path
