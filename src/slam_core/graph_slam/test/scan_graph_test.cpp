// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

using test::RoomDrive;

std::unique_ptr<GraphSlam> made(const GraphConfig& config = {},
                                const grid_map::GridMapConfig& grid = {}) {
  auto backend = std::make_unique<GraphSlam>();
  as<MapChooser>(*backend).useMap(MapKind::kGrid);
  backend->configure(config, grid);
  return backend;
}

Status take(GraphSlam& backend, const RoomDrive::Step& step, bool has_motion = true) {
  if (has_motion) give(step.motion, backend);
  give(step.scan, backend);
  return backend.execute();
}

/// @return the largest distance between pose and truth [m]
double run(GraphSlam& backend, RoomDrive& drive, int steps, bool has_motion = true) {
  double worst = 0.0;
  for (int i = 0; i < steps; ++i) {
    const auto step = drive.next();
    take(backend, step, has_motion);
    worst = std::max(worst, (backend.pose().pose.position() - step.truth.position()).norm());
  }
  return worst;
}

double figure(const GraphSlam& backend, const std::string& name) {
  for (const auto& [each, value] : backend.figures())
    if (each == name) return value;
  ADD_FAILURE() << "there is no figure " << name;
  return NAN;
}

OccupancyGrid gridOf(GraphSlam& backend) { return *as<GridMapper>(backend).grid(); }

TEST(ScanGraph, ClosesLoopsInEachLap) {
  const auto backend = made();
  RoomDrive drive(1);
  EXPECT_LT(run(*backend, drive, 3 * RoomDrive::kLap), 0.03);
  EXPECT_GT(backend->counters()["loops"], 10u);
  EXPECT_LT(figure(*backend, "rejected_loops"), 0.1 * figure(*backend, "loops"));
}

TEST(ScanGraph, StopsGrowingInARoomThatIsKnown) {
  const auto backend = made();
  RoomDrive drive(9);
  run(*backend, drive, 8 * RoomDrive::kLap);
  const double nodes = figure(*backend, "nodes"), megabytes = figure(*backend, "map_megabytes");
  EXPECT_LT(run(*backend, drive, 8 * RoomDrive::kLap), 0.05);
  EXPECT_LT(figure(*backend, "nodes"), 1.3 * nodes);
  EXPECT_LT(figure(*backend, "map_megabytes"), 1.3 * megabytes);
  EXPECT_GT(figure(*backend, "removed_nodes"), 0.5 * nodes);
  EXPECT_EQ(as<PathReviser>(*backend).path().size(), 16u * RoomDrive::kLap);
}

TEST(ScanGraph, NeedsNoMotion) {
  const auto backend = made();
  RoomDrive drive(2);
  EXPECT_LT(run(*backend, drive, 2 * RoomDrive::kLap, false), 0.04);
}

/// What is asked for in between must not show in the end.
TEST(ScanGraph, DrawsTheSameGridWheneverItIsAskedFor) {
  const auto asked = made(), left = made();
  RoomDrive first(3), second(3);
  for (int i = 0; i < 2 * RoomDrive::kLap; ++i) {
    take(*asked, first.next());
    take(*left, second.next());
    if (i % 20 == 0) gridOf(*asked);
  }
  EXPECT_EQ(gridOf(*asked).cells, gridOf(*left).cells);
}

TEST(ScanGraph, KeepsItsMapWhereMemoryEnds) {
  grid_map::GridMapConfig grid;
  grid.largest_memory = 0.5;
  const auto backend = made({}, grid);
  RoomDrive drive(4);
  std::vector<std::string> told;
  for (int i = 0; i < RoomDrive::kLap; ++i) told.push_back(take(*backend, drive.next()).message);
  EXPECT_GT(backend->counters()["scans_without_memory"], 0u);
  EXPECT_TRUE(test::oneSays(told, {"grid_map.largest_memory", "kept as it is"}));
}

/// The drawing that somebody asks for takes memory as well.
TEST(ScanGraph, StopsAtTheSameScanWhetherTheGridIsAskedForOrNot) {
  grid_map::GridMapConfig grid;
  grid.largest_memory = 2.0;
  const auto asked = made({}, grid), left = made({}, grid);
  RoomDrive first(8), second(8);
  for (int i = 0; i < 4 * RoomDrive::kLap; ++i) {
    take(*asked, first.next());
    take(*left, second.next());
    gridOf(*asked);
    ASSERT_EQ(asked->counters()["scans_without_memory"], left->counters()["scans_without_memory"])
        << "step " << i;
  }
  EXPECT_GT(left->counters()["scans_without_memory"], 0u) << figure(*left, "map_megabytes");
  EXPECT_GT(figure(*left, "nodes"), 10.0);
  EXPECT_EQ(gridOf(*asked).cells, gridOf(*left).cells);
}

TEST(ScanGraph, LocalisesInALoadedGridWithoutGrowing) {
  const auto mapping = made();
  RoomDrive drive(5);
  run(*mapping, drive, RoomDrive::kLap);
  GraphConfig config;
  config.mode = BackendMode::kLocalization;
  const auto localising = made(config);
  as<MapKeeper>(*localising).set(as<MapKeeper>(*mapping).state());
  localising->execute();
  const auto before = gridOf(*localising).cells;
  EXPECT_LT(run(*localising, drive, RoomDrive::kLap), 0.05);
  EXPECT_EQ(figure(*localising, "nodes"), 0.0);
  EXPECT_EQ(gridOf(*localising).cells, before);
}

TEST(ScanGraph, RefusesAMapWithoutAGridAndStaysAsItIs) {
  const auto backend = made();
  RoomDrive drive(6);
  run(*backend, drive, 30);
  const auto before = gridOf(*backend).cells;
  as<MapKeeper>(*backend).set(MapState{});
  const auto status = backend->execute();
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_TRUE(test::oneSays({status.message}, {"holds no occupancy grid"})) << status.message;
  EXPECT_EQ(gridOf(*backend).cells, before);
}

const std::vector<Eigen::Vector2d> kMarkers = {{3, 0.5}, {0.5, 3.5}, {-3.5, 2.0}, {-2.5, -1.0}};

enum class Images { kNone, kBetweenScans, kAtScans };

/// A drive with a camera as well; its odometry measures each step too long and turned.
class MarkerDrive {
 public:
  MarkerDrive(std::uint64_t seed, Images images) : room_(seed), images_(images) {
    room_.way_of_step = 0.05;
  }
  /// @return the distance between pose and truth [m]
  double step(GraphSlam& backend) {
    auto step = moved(backend);
    if (images_ == Images::kBetweenScans) look(backend, step);
    if (count_++ > 0) step = moved(backend);  // the first scan is taken before the robot moves
    if (images_ == Images::kAtScans) look(backend, step);
    give(step.scan, backend);
    EXPECT_NE(backend.execute().level, Status::Level::kError);
    return (backend.pose().pose.position() - step.truth.position()).norm();
  }

 private:
  RoomDrive::Step moved(GraphSlam& backend) {
    const auto step = room_.next();
    auto motion = step.motion;
    if (count_ > 0) motion.increment = motion.increment * Pose2(0.002, 0.0, 0.004);
    give(motion, backend);
    return step;
  }
  /// The estimator gives what is seen first, and a scan of the same stamp in a step of its own.
  void look(GraphSlam& backend, const RoomDrive::Step& step) {
    LandmarkObservationArray seen;
    seen.stamp = step.scan.stamp;
    for (std::size_t i = 0; i < kMarkers.size(); ++i)
      seen.observations.push_back(room_.sight(static_cast<LandmarkId>(i), kMarkers[i]));
    give(seen, backend);
    EXPECT_NE(backend.execute().level, Status::Level::kError);
  }

  RoomDrive room_;
  Images images_;
  int count_ = 0;
};

TEST(ScanGraph, IsAsGoodWithLandmarksAtTheStampsOfScansAsBetweenThem) {
  const auto errorOf = [](std::uint64_t seed, Images images) {
    const auto backend = made();
    MarkerDrive drive(seed, images);
    double sum = 0.0;
    for (int i = 0; i < 2 * RoomDrive::kLap; ++i) sum += std::pow(drive.step(*backend), 2);
    return std::sqrt(sum / (2 * RoomDrive::kLap));
  };
  for (std::uint64_t seed = 11; seed < 14; ++seed)
    for (const auto images : {Images::kBetweenScans, Images::kAtScans})
      EXPECT_LT(errorOf(seed, images), 0.015) << seed;
}

TEST(ScanGraph, RemovesNodesThatScansHaveJoined) {
  for (const auto mode : {BackendMode::kSlam, BackendMode::kLocalization}) {
    const auto mapping = made();
    MarkerDrive drive(12, Images::kBetweenScans);
    for (int i = 0; i < 2 * RoomDrive::kLap; ++i) drive.step(*mapping);
    GraphConfig config;
    config.mode = mode;
    const auto backend = made(config);
    as<MapKeeper>(*backend).set(as<MapKeeper>(*mapping).state());
    backend->execute();
    double worst = 0.0;
    for (int i = 0; i < 4 * RoomDrive::kLap; ++i) worst = std::max(worst, drive.step(*backend));
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(figure(*backend, "removed_nodes"), 200.0);
    EXPECT_EQ(as<PathReviser>(*backend).path().size(), 8u * RoomDrive::kLap);
  }
}

TEST(Submap, IsDrawnAgainToTheBit) {
  const grid_map::GridMapConfig config;
  const auto models = scan_matching::levelModels(config);
  Submap submap(config);
  RoomDrive drive(7);
  for (int i = 0; i < 20; ++i) {
    const auto scan = std::make_shared<const LaserScan>(drive.next().scan);
    submap.insert(scan, scan_matching::pointsOf(*scan, models, 0.02), i, Pose2(0.1 * i, 0, 0));
  }
  const auto cells = [&] {
    const auto& level = submap.map().finest();
    return grid_map::occupancyGridOf(level.map, level.model.resolution()).cells;
  };
  const auto before = cells();
  submap.giveUpDrawing();
  EXPECT_EQ(submap.bytes(), 0u);
  EXPECT_EQ(cells(), before);
}

TEST(Submap, HangsOnTheNodeOfTheNearestScanOrOnTheLoadedGrid) {
  constexpr graph::Key kLoaded = 3, kFirst = 10;
  const grid_map::GridMapConfig config;
  Submap drawn(config);
  Submap loaded(std::make_unique<scan_matching::ScanMap>(config), kLoaded, {Pose2(-5.0, 0.0, 0.0)});
  const auto scan = std::make_shared<const LaserScan>();
  const auto points = scan_matching::pointsOf(*scan, scan_matching::levelModels(config), 0.02);
  for (int i = 0; i < 5; ++i)
    for (auto* submap : {&drawn, &loaded})
      submap->insert(scan, points, kFirst + i, Pose2(0.4 * i, 0.0, 0.0));
  EXPECT_EQ(nearestAnchor(drawn, {1.3, 0.5, 2.0}).node, kFirst + 3);
  EXPECT_EQ(nearestAnchor(drawn, {1.3, 0.5, 2.0}).pose.x(), 0.4 * 3);
  EXPECT_EQ(nearestAnchor(loaded, {1.3, 0.5, 2.0}).node, kLoaded) << "what was loaded is rigid";
}

}  // namespace
}  // namespace slam::graph_slam
