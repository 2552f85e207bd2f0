// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_map.hpp"

#include <gtest/gtest.h>

namespace slam::grid_map {
namespace {

void write(GridMap& map, CellIndex cell, LogOdds value) {
  map.ownTile(cell)->log_odds[Tile::at(cell)] = value;
}

TEST(GridMapTest, IsUnseenWhereNothingWasWritten) {
  GridMap::Memory memory;
  GridMap map(memory);
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.logOdds({5, -7}), kUnseen);
  write(map, {5, -7}, 3);
  EXPECT_EQ(map.logOdds({5, -7}), 3);
  EXPECT_EQ(map.logOdds({6, -7}), kUnseen);
  EXPECT_EQ(map.logOdds({1000000, 5}), kUnseen);
}

TEST(GridMapTest, KeepsItsCellsWhenItGrowsInAnyDirection) {
  GridMap::Memory memory;
  GridMap map(memory);
  const CellIndex cells[] = {{0, 0}, {500, 3}, {-700, -2}, {4, 900}, {31, -1000}, {-1, -1}};
  LogOdds value = 0;
  for (const auto cell : cells) write(map, cell, ++value);
  value = 0;
  for (const auto cell : cells) EXPECT_EQ(map.logOdds(cell), ++value);
  EXPECT_EQ(map.tiles(), 6u) << "only those that were written";
}

TEST(GridMapTest, SharesTilesBetweenCopiesUntilOneWritesThem) {
  GridMap::Memory memory;
  GridMap map(memory);
  for (int i = 0; i < 10; ++i) write(map, {Tile::kSize * i, 0}, 1);
  GridMap copy = map;
  EXPECT_EQ(copy.identity(), map.identity());
  EXPECT_EQ(memory.tilesInUse(), 10u);
  write(copy, {0, 0}, 2);
  EXPECT_EQ(memory.tilesInUse(), 11u);
  EXPECT_EQ(map.logOdds({0, 0}), 1);
  EXPECT_EQ(copy.logOdds({0, 0}), 2);
  EXPECT_NE(copy.identity(), map.identity());
  copy = map;
  EXPECT_EQ(memory.tilesInUse(), 10u) << "what nobody holds is given back";
}

TEST(GridMapTest, GrowsNoFurtherThanItsLargestRectangle) {
  GridMap::Memory memory(6);
  GridMap map(memory);
  write(map, {0, 0}, 1);
  write(map, {2 * Tile::kSize, Tile::kSize}, 1);  // three by two tiles
  EXPECT_EQ(map.ownTile({3 * Tile::kSize, 0}), nullptr);
  EXPECT_EQ(map.ownTile({INT32_MAX, INT32_MIN}), nullptr);
  EXPECT_NE(map.ownTile({Tile::kSize, 0}), nullptr) << "there is room within";
  EXPECT_EQ(map.logOdds({0, 0}), 1);
}

TEST(GridMapTest, TakesATileBackToWhatACopyOfItHas) {
  GridMap::Memory memory;
  GridMap map(memory);
  write(map, {5, 5}, 3);
  const GridMap before = map;
  write(map, {5, 5}, 4);
  write(map, {25, 5}, 6);
  write(map, {500, 5}, 7);
  map.restoreTile({0, 0}, before);
  map.restoreTile({16, 0}, before);
  map.restoreTile({-3000, 9}, before);
  EXPECT_EQ(map.logOdds({5, 5}), 3);
  EXPECT_EQ(map.logOdds({25, 5}), kUnseen);
  EXPECT_EQ(map.logOdds({500, 5}), 7);
  EXPECT_EQ(memory.tilesInUse(), 2u);
  write(map, {5, 5}, 9);
  EXPECT_EQ(before.logOdds({5, 5}), 3);
}

}  // namespace
}  // namespace slam::grid_map
