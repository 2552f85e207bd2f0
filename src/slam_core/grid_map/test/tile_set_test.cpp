// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/tile_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/common/random.hpp"

namespace slam::grid_map {
namespace {

CellIndex somewhere(RandomStream& random, double spread) {
  return {static_cast<std::int32_t>(spread * random.gaussian()) - 7,
          static_cast<std::int32_t>(spread * random.gaussian()) + 3};
}

TEST(TileSet, TouchesTheRectanglesThatHoldOneOfItsTiles) {
  RandomStream random(1, 0);
  std::vector<CellIndex> tiles;
  for (int i = 0; i < 40; ++i) tiles.push_back(somewhere(random, 8.0));
  tiles.push_back(tiles.front());
  const TileSet set(tiles);
  int touched = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto a = somewhere(random, 12.0), b = i % 2 == 0 ? a : somewhere(random, 12.0);
    const bool is_held = std::any_of(tiles.begin(), tiles.end(), [&](CellIndex tile) {
      return tile.x >= std::min(a.x, b.x) && tile.x <= std::max(a.x, b.x) &&
             tile.y >= std::min(a.y, b.y) && tile.y <= std::max(a.y, b.y);
    });
    ASSERT_EQ(set.touches(a, b), is_held) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
    touched += is_held;
  }
  EXPECT_GT(touched, 200);
  EXPECT_LT(touched, 1800);
}

TEST(TileSet, HoldsEachTileOnce) {
  const TileSet set({{3, 1}, {-2, 5}, {3, 1}, {0, 1}});
  ASSERT_EQ(set.tiles().size(), 3u);
  EXPECT_EQ(set.tiles().front(), (CellIndex{0, 1}));
  EXPECT_TRUE(set.contains({-2, 5}));
  EXPECT_FALSE(set.contains({-2, 1}));
}

TEST(TileSet, TouchesNothingWithoutTiles) {
  const TileSet set({});
  EXPECT_TRUE(set.tiles().empty());
  EXPECT_FALSE(set.touches({-100, -100}, {100, 100}));
}

}  // namespace
}  // namespace slam::grid_map
