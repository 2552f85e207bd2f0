// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_insertion.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "slam_core/common/random.hpp"
#include "slam_core/grid_map/likelihood.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::grid_map {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

LaserScan scanWith(std::vector<LaserBeam> beams) {
  LaserScan scan;
  scan.beams = std::move(beams);
  return scan;
}

class ScanInsertion : public testing::Test {
 protected:
  void insert(const LaserScan& scan, const Pose2& pose = {}) {
    beyond = insertScan(model, pointsOf(scan, model, 0.05), pose, map);
  }
  LogOdds at(double x, double y) const {
    return map.logOdds({static_cast<std::int32_t>(std::floor(x / model.resolution())),
                        static_cast<std::int32_t>(std::floor(y / model.resolution()))});
  }

  GridMapConfig config;
  BeamModel model{config};
  GridMap::Memory memory;
  GridMap map{memory};
  std::size_t beyond = 0;
};

TEST_F(ScanInsertion, FreesTheCellsOnABeamsWayAndOccupiesItsEnd) {
  insert(scanWith({{0.0f, 1.02f, true}}), Pose2(0.52, 0.02, M_PI / 2));
  for (double y = 0.03; y < 1.0; y += 0.05) EXPECT_LT(at(0.52, y), 0) << y;
  EXPECT_GT(at(0.52, 1.04), 0);
  EXPECT_EQ(at(0.52, 1.09), kUnseen);
  EXPECT_EQ(at(0.57, 0.5), kUnseen);
}

TEST_F(ScanInsertion, FreesTheWayOfABeamFromItsOwnLaser) {
  auto joined = scanWith({{0.0f, 1.02f, true}});
  joined.sensor_pose = Pose2(0.52, 0.02, 0.0);
  joined.further = {{}};
  joined.further[0].sensor_pose = Pose2(-0.48, 0.52, M_PI);
  joined.further[0].beams = {{0.0f, 1.02f, true}};
  insert(joined);
  for (double x = 0.53; x < 1.5; x += 0.05) EXPECT_LT(at(x, 0.02), 0) << x;
  for (double x = -0.53; x > -1.45; x -= 0.05) EXPECT_LT(at(x, 0.52), 0) << x;
  EXPECT_GT(at(1.54, 0.02), 0);
  EXPECT_GT(at(-1.5, 0.52), 0);
  for (double x = -1.4; x < 0.5; x += 0.05) EXPECT_EQ(at(x, 0.02), kUnseen) << x;
  for (double x = -0.43; x < 1.5; x += 0.05) EXPECT_EQ(at(x, 0.52), kUnseen) << x;
}

TEST_F(ScanInsertion, JoinedScansMakeTheMapOfTheirPartsWhereTheseDoNotMeet) {
  test::Room room;
  RandomStream random(3, 0);
  const Pose2 front(0.2, 0.0, 0.0), rear(-0.2, 0.0, M_PI), base = test::RoomDrive::start();
  auto joined = test::scanOf(room, base, front, 181, 0.0, random);
  const auto behind = test::scanOf(room, base, rear, 181, 0.0, random);
  insert(joined);
  insert(behind);
  const GridMap apart = map;
  map = GridMap(memory);
  joined.further = {behind};
  insert(joined);
  std::size_t same = 0, cells = 0;
  for (std::int32_t y = -120; y < 120; ++y)
    for (std::int32_t x = -120; x < 120; ++x) {
      if (apart.logOdds({x, y}) == kUnseen && map.logOdds({x, y}) == kUnseen) continue;
      ++cells;
      same += apart.logOdds({x, y}) == map.logOdds({x, y});
    }
  EXPECT_GT(cells, 5000u);
  EXPECT_GT(static_cast<double>(same), 0.97 * static_cast<double>(cells));
}

TEST_F(ScanInsertion, FreesNothingAlongABeamThatMetNothingUnlessToldSo) {
  insert(scanWith({{0.0f, 80.0f, false}}));
  EXPECT_TRUE(map.isEmpty());
  config.free_range = 2.0;
  model = BeamModel(config);
  insert(scanWith({{0.0f, 80.0f, false}, {1.5707963f, 1.0f, false}}));
  EXPECT_LT(at(1.9, 0.01), 0);
  EXPECT_EQ(at(2.1, 0.01), kUnseen);
  EXPECT_LT(at(0.01, 0.9), 0) << "a beam is not free beyond where the sensor can see";
  EXPECT_EQ(at(0.01, 1.1), kUnseen);
}

TEST_F(ScanInsertion, FreesTheWayToAnEndBeyondTheUsableRange) {
  config.usable_range = 3.0;
  model = BeamModel(config);
  insert(scanWith({{0.0f, 5.0f, true}}));
  EXPECT_LT(at(2.9, 0.01), 0);
  EXPECT_EQ(at(3.1, 0.01), kUnseen);
  EXPECT_EQ(at(5.0, 0.01), kUnseen);
}

TEST_F(ScanInsertion, LeavesOutWhatIsNoNumber) {
  insert(scanWith({{0.0f, kNan, true},
                   {0.1f, kInf, true},
                   {0.2f, -kInf, true},
                   {kNan, 1.0f, true},
                   {0.3f, 0.0f, true},
                   {0.4f, -1.0f, true},
                   {0.5f, kInf, false},
                   {0.6f, kNan, false}}));
  const auto rectangle = map.rectangle();
  EXPECT_LE(rectangle.width, 40 / config.resolution) << "infinite is as far as is usable";
  GridMap untouched = map;
  LaserScan scan = scanWith({{0.0f, 1.0f, true}});
  scan.sensor_pose = Pose2(kNan, 0, 0);
  insert(scan);
  insert(scanWith({{0.0f, 1.0f, true}}), Pose2(0, kInf, 0));
  insert(scanWith({{0.0f, 1.0f, true}}), Pose2(1e12, 0, 0));
  insert(scanWith({}));
  EXPECT_EQ(map.identity(), untouched.identity());
}

TEST_F(ScanInsertion, AnEndIsNotOnTheWayOfAnotherBeamOfTheScan) {
  // along a wall, where the further beams pass the cells in which the nearer ones end
  std::vector<LaserBeam> beams;
  for (int i = 1; i < 60; ++i) {
    const double bearing = M_PI / 2 - 0.025 * i;
    beams.push_back(
        {static_cast<float>(bearing), static_cast<float>(0.52 / std::sin(bearing)), true});
  }
  insert(scanWith(beams), Pose2(0.02, 0, 0));
  for (const auto& beam : beams) EXPECT_GT(at(0.02 + beam.end().x(), 0.52), 0);
}

TEST_F(ScanInsertion, AnEndIsNotOnTheWayOfAnotherBeamWhicheverItsCell) {
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0}) {
      map = GridMap(memory);
      const double cell = config.resolution;
      insert(scanWith({{0.0f, 1.0f, true}, {0.0f, 2.0f, true}}),
             Pose2((x + 0.5) * cell - 1.0, (y + 0.5) * cell, 0.0));
      EXPECT_EQ(at((x + 0.5) * cell, (y + 0.5) * cell), model.gainOf(0.0)) << x << " " << y;
    }
}

TEST_F(ScanInsertion, AnEndCountsAsMuchAsItsRangeTells) {
  config.largest_probability = 0.999;
  model = BeamModel(config);
  LaserScan far = scanWith({{0.0f, 3.02f, true}}), near = scanWith({{1.57f, 0.52f, true}});
  far.relative_sigma = near.relative_sigma = 0.01;  // 3 cm and half a cm, of a cell of 5 cm
  insert(far);
  insert(near);
  const auto end_of_near = near.beams[0].end();
  EXPECT_EQ(at(end_of_near.x(), end_of_near.y()), model.gainOf(0.0)) << "as much as without noise";
  const int once = at(3.02, 0.0);
  EXPECT_NEAR(once, model.gainOf(0.0) * std::pow(0.025 / 0.0906, 2), 0.5);
  EXPECT_LT(1.0 / (1.0 + std::exp(-once / kLogOddsUnit)), 0.65) << "one alone makes no wall";
  for (int i = 0; i < 15; ++i) insert(far);
  EXPECT_EQ(at(3.02, 0.0), 16 * once) << "many do";
  far.relative_sigma = 10.0;
  insert(far);
  EXPECT_EQ(at(3.02, 0.0), 16 * once + 1) << "none counts for nothing";
}

/// A wall across the way, seen again and again with 3 cm of noise, in cells of 5 cm.
TEST_F(ScanInsertion, ANoisyBeamMetTheSurfaceThatIsKnownThere) {
  constexpr double kWall = 3.02;
  RandomStream random(1, 0);
  for (int i = 0; i < 100; ++i) {
    std::vector<LaserBeam> beams;
    for (double bearing = -0.3; bearing < 0.3; bearing += 0.01) {
      const double noise = 1.0 + 0.01 * random.gaussian();
      beams.push_back({static_cast<float>(bearing),
                       static_cast<float>(noise * kWall / std::cos(bearing)), true});
    }
    auto scan = scanWith(std::move(beams));
    scan.relative_sigma = 0.01;
    insert(scan);
  }
  int on_wall = 0, in_front = 0, behind = 0;
  for (double y = -0.8; y < 0.8; y += 0.05)
    for (double x = 2.525; x < 3.5; x += 0.05) {
      if (at(x, y) < model.gainOf(0.0)) continue;  // what a precise beam would have told
      on_wall += std::abs(x - kWall) <= 0.05;
      in_front += x < kWall - 0.05;
      behind += x > kWall + 0.05;
    }
  EXPECT_GE(on_wall, 30) << "of 32 rows";
  EXPECT_EQ(in_front, 0);
  EXPECT_LE(behind, 1);
}

TEST_F(ScanInsertion, ANoisyBeamFreesNothingThatItMayHaveMet) {
  auto scan = scanWith({{0.0f, 3.02f, true}});
  scan.relative_sigma = 0.02;
  insert(scan);
  EXPECT_LT(at(2.77, 0.01), 0);
  for (double x = 2.86; x < 3.0; x += 0.05) EXPECT_EQ(at(x, 0.01), kUnseen) << x;
  EXPECT_GT(at(3.02, 0.01), 0);
}

TEST_F(ScanInsertion, ANoisyBeamPassesASurfaceThatIsNotWithinItsNoise) {
  for (int i = 0; i < 50; ++i) insert(scanWith({{0.0f, 2.02f, true}}));
  auto scan = scanWith({{0.0f, 3.02f, true}});
  scan.relative_sigma = 0.1;
  insert(scan);
  EXPECT_GT(at(2.02, 0.01), 0) << "0.9 m of noise, three sigma";
  scan.relative_sigma = 0.05;
  for (int i = 0; i < 10; ++i) insert(scan);
  EXPECT_LT(at(2.02, 0.01), 0);
  EXPECT_GT(at(3.02, 0.01), 0);
}

TEST_F(ScanInsertion, FollowsWhatChanges) {
  for (int i = 0; i < 50; ++i) insert(scanWith({{0.0f, 1.02f, true}}));
  EXPECT_GT(at(1.02, 0.0), 0);
  for (int i = 0; i < 10; ++i) insert(scanWith({{0.0f, 2.02f, true}}));
  EXPECT_LT(at(1.02, 0.0), 0);
  EXPECT_GT(at(2.02, 0.0), 0);
}

TEST_F(ScanInsertion, CopiesNothingOfWhatItOnlyConfirms) {
  for (int i = 0; i < 50; ++i) insert(scanWith({{0.0f, 1.02f, true}}));
  const GridMap copy = map;
  insert(scanWith({{0.0f, 1.02f, true}}));
  EXPECT_EQ(copy.identity(), map.identity());
}

TEST_F(ScanInsertion, TellsOfBeamsThatEndBeyondTheLargestMap) {
  GridMap::Memory small(4);
  map = GridMap(small);
  insert(scanWith({{0.0f, 1.0f, true}, {0.0f, 25.0f, true}}));
  EXPECT_EQ(beyond, 1u);
  EXPECT_GT(at(1.0, 0.0), 0) << "the rest is mapped";
  map = GridMap(memory);
}

TEST_F(ScanInsertion, MapsARoomWithinACellOfItsWalls) {
  test::RoomDrive drive(1);
  for (int i = 0; i < test::RoomDrive::kLap; ++i) {
    const auto step = drive.next();
    insert(step.scan, drive.start() * step.truth);
  }
  int occupied = 0, wrong = 0;
  const auto all = map.rectangle();
  for (std::int32_t y = all.least.y; y < all.least.y + all.height; ++y)
    for (std::int32_t x = all.least.x; x < all.least.x + all.width; ++x) {
      if (map.logOdds({x, y}) <= 0) continue;
      ++occupied;
      wrong += drive.room().distance(config.resolution * Eigen::Vector2d(x + 0.5, y + 0.5)) > 0.06;
    }
  EXPECT_GT(occupied, 600) << "36 m of walls";
  EXPECT_LT(wrong, occupied / 50);
}

/// After many scans the likelihood of each cell is that of the occupied cells around it as they
/// are, up to what means of ends have moved since.
TEST_F(ScanInsertion, KeepsLikelihoodsInStepWithOccupiedCells) {
  test::RoomDrive drive(2);
  for (int i = 0; i < 60; ++i) {
    const auto step = drive.next();
    insert(step.scan, drive.start() * step.truth);
  }
  const auto all = map.rectangle();
  for (std::int32_t y = all.least.y + 4; y < all.least.y + all.height - 4; ++y)
    for (std::int32_t x = all.least.x + 4; x < all.least.x + all.width - 4; ++x) {
      const auto* const tile = map.tile({x, y});
      if (tile == nullptr) continue;
      double nearest = INFINITY;
      for (std::int32_t v = y - model.reach(); v <= y + model.reach(); ++v)
        for (std::int32_t u = x - model.reach(); u <= x + model.reach(); ++u) {
          if (map.logOdds({u, v}) <= 0) continue;
          const auto* const other = map.tile({u, v});
          const auto i = Tile::at({u, v});
          nearest = std::min(nearest, std::hypot(u + other->mean_x[i] / 256.0 - x,
                                                 v + other->mean_y[i] / 256.0 - y));
        }
      const double sigmas = nearest * config.resolution / config.sigma;
      const double expected = 255.0 * std::exp(-0.5 * sigmas * sigmas);
      EXPECT_GE(tile->likelihood[Tile::at({x, y})] + 1.0, expected) << x << " " << y;
      if (std::isinf(nearest)) {
        EXPECT_EQ(tile->likelihood[Tile::at({x, y})], 0) << x << " " << y;
      }
    }
}

class ScanDrawing : public ScanInsertion {
 protected:
  void SetUp() override {
    RandomStream random(5, 0);
    const test::Room room;
    for (int i = 0; i < 12; ++i) {
      poses.emplace_back(0.2 * i - 3.0, -2.2, 0.4 * i);
      scans.push_back(pointsOf(scanOf(room, poses.back(), {}, 91, 0.02, random), model, 0.05));
    }
  }
  void draw(const TileSet* among, GridMap& to) const {
    for (std::size_t i = 0; i < scans.size(); ++i) drawScan(model, scans[i], poses[i], among, to);
  }
  /// Calls look(tile, cell) for all cells around the room.
  template <class Look>
  static void lookAround(const Look& look) {
    for (std::int32_t y = -200; y < 200; ++y)
      for (std::int32_t x = -200; x < 200; ++x)
        look(CellIndex{x >> Tile::kBits, y >> Tile::kBits}, CellIndex{x, y});
  }

  std::vector<Pose2> poses;
  std::vector<ScanPoints> scans;
  GridMap drawn{memory};
};

TEST_F(ScanDrawing, ShowsWhatAMapToMatchWithShows) {
  for (std::size_t i = 0; i < scans.size(); ++i) insertScan(model, scans[i], poses[i], map);
  draw(nullptr, drawn);
  int seen = 0;
  lookAround([&](CellIndex, CellIndex cell) {
    ASSERT_EQ(drawn.logOdds(cell), map.logOdds(cell));
    seen += drawn.logOdds(cell) != kUnseen;
  });
  EXPECT_GT(seen, 3000);
}

TEST_F(ScanDrawing, DrawsTheTilesAlikeAmongWhichItIsToStay) {
  draw(nullptr, drawn);
  const TileSet some({{-3, -3}, {0, -3}, {1, -2}, {4, 0}, {4, 1}});
  draw(&some, map);
  int seen = 0;
  lookAround([&](CellIndex tile, CellIndex cell) {
    ASSERT_EQ(map.logOdds(cell), some.contains(tile) ? drawn.logOdds(cell) : kUnseen);
    seen += map.logOdds(cell) != kUnseen;
  });
  EXPECT_GT(seen, 300);
}

TEST_F(ScanDrawing, TellsTheTilesThatAScanWritesTo) {
  std::vector<CellIndex> tiles;
  addTilesOf(scans[3], poses[3], tiles);
  const TileSet told(tiles);
  EXPECT_EQ(told.tiles().size(), tiles.size()) << "each is told once";
  drawScan(model, scans[3], poses[3], nullptr, drawn);
  std::vector<CellIndex> written;
  lookAround([&](CellIndex tile, CellIndex cell) {
    if (drawn.logOdds(cell) != kUnseen) written.push_back(tile);
  });
  EXPECT_EQ(TileSet(written).tiles(), told.tiles());
}

}  // namespace
}  // namespace slam::grid_map
