// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/graph_slam/session_graph.hpp"
#include "slam_core/graph_slam/session_merge.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

using test::RoomDrive;
using test::sentenceOf;
using test::SimulatedWorld;

struct Options {
  bool has_grid = false;
  BackendMode mode = BackendMode::kSlam;
  double resolution = 0.05;
};

std::unique_ptr<GraphSlam> madeFor(const Options& options = {}) {
  auto backend = std::make_unique<GraphSlam>();
  as<MapChooser>(*backend).useMap(options.has_grid ? MapKind::kGrid : MapKind::kLandmarks);
  GraphConfig config;
  config.mode = options.mode;
  grid_map::GridMapConfig grid;
  grid.resolution = options.resolution;
  backend->configure(config, grid);
  return backend;
}

Pose2 drive(GraphSlam& backend, SimulatedWorld& world, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) {
    const auto step = world.next();
    backend.set(step.motion);
    backend.set(step.observations);
    backend.execute();
    truth = step.truth;
  }
  return truth;
}

Pose2 drive(GraphSlam& backend, RoomDrive& room, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) {
    const auto step = room.next();
    give(step.motion, backend);
    give(step.scan, backend);
    backend.execute();
    truth = step.truth;
  }
  return truth;
}

/// Past a few landmarks that are seen between the scans.
void driveWithLandmarks(GraphSlam& backend, RoomDrive& room, int steps) {
  for (int i = 0; i < steps; ++i) {
    const auto step = room.next();
    give(step.motion, backend);
    LandmarkObservationArray seen;
    seen.stamp = step.scan.stamp;
    for (const auto& [id, place] :
         std::map<LandmarkId, Eigen::Vector2d>{{1, {3, 0.5}}, {2, {0, 3}}})
      seen.observations.push_back(room.sight(id, place));
    give(seen, backend);
    backend.execute();
    drive(backend, room, 1);
  }
}

std::string saved(GraphSlam& backend) { return as<SessionKeeper>(backend).session().bytes; }

void load(GraphSlam& backend, const std::string& session) {
  as<SessionKeeper>(backend).set(SavedSession{session});
  const auto status = backend.execute();
  EXPECT_TRUE(status.isOk()) << status.message;
}

std::unique_ptr<GraphSlam> resumed(const std::string& session, const Options& options = {}) {
  auto backend = madeFor(options);
  load(*backend, session);
  return backend;
}

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

double worstOf(const std::vector<StampedPose>& a, const std::vector<StampedPose>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    worst = std::max(worst, distance(a[i].pose, b[i].pose));
  return worst;
}

std::vector<StampedPose> pathOf(GraphSlam& backend) { return as<PathReviser>(backend).path(); }

/// The nodes of a back-end's graph once it is optimised until it rests.
std::vector<StampedPose> settled(GraphSlam& backend) {
  auto session = sessionOf(saved(backend));
  settle(session);
  std::vector<StampedPose> path;
  for (const auto& pose : session.nodes) path.push_back({Stamp(), pose});
  return path;
}

TEST(Session, IsSavedAgainToTheBit) {
  const auto landmarks = madeFor(), grid = madeFor({true});
  SimulatedWorld world(1);
  drive(*landmarks, world, SimulatedWorld::kLap + 33);
  EXPECT_EQ(saved(*landmarks), saved(*resumed(saved(*landmarks))));
  RoomDrive room(1);
  drive(*grid, room, 2 * RoomDrive::kLap);
  EXPECT_EQ(saved(*grid), saved(*resumed(saved(*grid), {true})));
}

TEST(Session, KeepsTheMotionsThatScansAddToTheOdometry) {
  const auto first = madeFor({true});
  RoomDrive room(12), again(12);
  driveWithLandmarks(*first, room, RoomDrive::kLap);
  const auto bytes = saved(*first);
  const auto session = sessionOf(bytes);
  EXPECT_GT(session.chords.size(), 50u);
  EXPECT_TRUE(session.submaps.reference);
  const auto second = resumed(bytes, {true});
  EXPECT_EQ(saved(*second), bytes);
  const Pose2 truth = drive(*second, room, 30);
  EXPECT_LT(distance(second->pose().pose, truth), 0.03);
}

TEST(Session, LeavesTheRobotWhereItWas) {
  const auto backend = madeFor();
  SimulatedWorld world(2);
  drive(*backend, world, SimulatedWorld::kLap);
  const auto loaded = resumed(saved(*backend));
  EXPECT_EQ(loaded->pose().pose.vector(), backend->pose().pose.vector());
  EXPECT_LT((loaded->pose().covariance - backend->pose().covariance).norm(),
            0.05 * backend->pose().covariance.norm());
  EXPECT_EQ(worstOf(pathOf(*loaded), pathOf(*backend)), 0.0);
}

/// Where the graph was linearised differs by up to OptimizerLimits::correction. So the paths differ
/// by less than a quarter of the pose's standard deviation, and are the same once both are settled.
TEST(Session, GoesOnWithLandmarksAsIfItHadNeverStopped) {
  for (const std::uint64_t seed : {1, 3, 5, 7}) {
    const auto whole = madeFor(), first = madeFor();
    SimulatedWorld world(seed), again(seed);
    drive(*whole, world, 2 * SimulatedWorld::kLap);
    drive(*first, again, SimulatedWorld::kLap / 2 + 3);
    const auto second = resumed(saved(*first));
    drive(*second, again, 2 * SimulatedWorld::kLap - SimulatedWorld::kLap / 2 - 3);
    const double sigma = std::sqrt(whole->pose().covariance.topLeftCorner<2, 2>().trace());
    EXPECT_LT(worstOf(pathOf(*second), pathOf(*whole)), 0.25 * sigma) << "seed " << seed;
    EXPECT_LT(worstOf(settled(*second), settled(*whole)), 1e-4) << "seed " << seed;
    EXPECT_EQ(as<LandmarkMapper>(*second).landmarks().size(),
              as<LandmarkMapper>(*whole).landmarks().size());
  }
}

TEST(Session, GoesOnWithScansAsIfItHadNeverStopped) {
  const auto whole = madeFor({true}), first = madeFor({true});
  RoomDrive room(4), again(4);
  drive(*whole, room, 3 * RoomDrive::kLap);
  drive(*first, again, RoomDrive::kLap);
  const auto second = resumed(saved(*first), {true});
  const Pose2 truth = drive(*second, again, 2 * RoomDrive::kLap);
  EXPECT_LT(distance(second->pose().pose, truth), 0.03);
  EXPECT_LT(worstOf(pathOf(*second), pathOf(*whole)), 0.03);
  EXPECT_GT(second->counters()["loops"], 10u);
}

TEST(Session, KeepsALandmarkRemovedThatWasRemovedAndFoundAnew) {
  SimulatedWorld world(1);
  auto first = madeFor();
  drive(*first, world, 80);
  ASSERT_TRUE(as<LandmarkRemover>(*first).remove(10).isOk());
  ASSERT_TRUE(as<LandmarkRemover>(*first).remove(13).isOk());
  const auto size = as<LandmarkMapper>(*first).landmarks().size();
  EXPECT_EQ(as<LandmarkMapper>(*resumed(saved(*first))).landmarks().size(), size);
  drive(*first, world, SimulatedWorld::kLap);
  const auto session = saved(*first);
  auto second = resumed(session);
  EXPECT_EQ(saved(*second), session);
  const auto map = as<LandmarkMapper>(*second).landmarks();
  EXPECT_EQ(map.size(), world.landmarks().size());
  for (const auto& landmark : map)
    EXPECT_LT((landmark.position - world.landmarks().at(landmark.id)).norm(), 0.2);
}

TEST(Session, OfIdsOfItsOwnMakingIsRefusedWhereIdsDecide) {
  auto by_place = std::make_unique<GraphSlam>();
  GraphConfig config;
  config.association = "jcbb";
  by_place->configure(config);
  SimulatedWorld world(1);
  drive(*by_place, world, 80);
  const auto session = saved(*by_place);
  EXPECT_TRUE(sessionOf(session).kind.has_own_ids);
  EXPECT_FALSE(sessionOf(saved(*madeFor())).kind.has_own_ids);
  auto by_id = madeFor();
  EXPECT_EQ(sentenceOf([&] { as<SessionKeeper>(*by_id).set(SavedSession{session}); }),
            "its landmarks have ids of its own making and this product goes by the ids of "
            "observations: run a product with association: nearest, jcbb or descriptor");
  drive(*by_place, world, 20);
  load(*by_place, session);
  EXPECT_EQ(saved(*by_place), session) << "it goes on where ids are not looked at";
}

TEST(Session, KeepsTheDescriptorsOfItsLandmarks) {
  SimulatedWorld world(1);
  auto backend = madeFor();
  for (int i = 0; i < 60; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations)
      z.descriptor = descriptorOf(0.01 * double(z.id), 0.05);
    backend->set(step.motion);
    backend->set(step.observations);
    backend->execute();
  }
  const auto again = resumed(saved(*backend));
  const auto map = as<LandmarkMapper>(*again).landmarks();
  ASSERT_FALSE(map.empty());
  for (const auto& landmark : map) {
    EXPECT_NEAR(landmark.descriptor.values(0), 0.01 * double(landmark.id), 1e-6);
    EXPECT_LE(landmark.descriptor.sigmas(0), 0.05F);
  }
}

TEST(Session, GoesOnInTheSameWayEachTime) {
  const auto first = madeFor({true});
  RoomDrive room(5);
  drive(*first, room, RoomDrive::kLap);
  const auto session = saved(*first);
  const auto a = resumed(session, {true}), b = resumed(session, {true});
  RoomDrive same = room;
  drive(*a, room, RoomDrive::kLap);
  drive(*b, same, RoomDrive::kLap);
  EXPECT_EQ(saved(*a), saved(*b));
}

/// The bags of two runs have nothing to tell of the motion from the end of one to the next.
TEST(Session, CrossesAShortPauseByTheOdometry) {
  const auto first = madeFor();
  SimulatedWorld world(6);
  drive(*first, world, SimulatedWorld::kLap);
  const auto second = resumed(saved(*first));
  for (int i = 0; i < 4; ++i) world.next();
  EXPECT_LT(distance(second->pose().pose, drive(*second, world, 1)), 0.15);
}

TEST(Session, IsLocalisedInAndDoesNotMove) {
  for (const bool has_grid : {false, true}) {
    const auto first = madeFor({has_grid});
    SimulatedWorld world(7);
    RoomDrive room(7);
    const auto go = [&](GraphSlam& backend) {
      return has_grid ? drive(backend, room, 20) : drive(backend, world, 20);
    };
    for (int i = 0; i < 10; ++i) go(*first);
    const auto map = as<LandmarkMapper>(*first).landmarks();
    const auto second = resumed(saved(*first), {has_grid, BackendMode::kLocalization});
    const auto grid = has_grid ? as<GridMapper>(*second).grid()->cells : std::vector<std::int8_t>();
    EXPECT_EQ(grid, has_grid ? as<GridMapper>(*first).grid()->cells : grid);
    Pose2 truth;
    for (int i = 0; i < 5; ++i) truth = go(*second);
    EXPECT_LT(distance(second->pose().pose, truth), 0.2);
    const auto after = as<LandmarkMapper>(*second).landmarks();
    ASSERT_EQ(after.size(), map.size());
    for (std::size_t i = 0; i < map.size(); ++i) EXPECT_EQ(after[i].position, map[i].position);
    if (has_grid) {
      EXPECT_EQ(as<GridMapper>(*second).grid()->cells, grid);
    }
    EXPECT_TRUE(test::oneSays({sentenceOf([&] { saved(*second); })},
                              {"mode: localization", "still in its file"}));
  }
}

TEST(Session, GoesOnWhereAnInitialPosePutsTheRobot) {
  const auto first = madeFor();
  SimulatedWorld world(8);
  const Pose2 truth = drive(*first, world, SimulatedWorld::kLap);
  const auto map = as<LandmarkMapper>(*first).landmarks();
  const auto second = resumed(saved(*first));
  drive(*second, world, 3);
  second->set(PoseEstimate{truth, 0.01 * Eigen::Matrix3d::Identity()});
  second->execute();
  EXPECT_LT(distance(second->pose().pose, truth), 1e-9);
  const auto after = as<LandmarkMapper>(*second).landmarks();
  for (std::size_t i = 0; i < map.size(); ++i)
    EXPECT_LT((after[i].position - map[i].position).norm(), 0.05);
}

TEST(Session, KeepsAGridThatWasLoaded) {
  const auto first = madeFor({true});
  RoomDrive room(9);
  drive(*first, room, RoomDrive::kLap);
  const auto second = madeFor({true});
  as<MapKeeper>(*second).set(as<MapKeeper>(*first).state());
  second->execute();
  drive(*second, room, RoomDrive::kLap / 2);
  const auto third = resumed(saved(*second), {true});
  EXPECT_EQ(as<GridMapper>(*third).grid()->cells, as<GridMapper>(*second).grid()->cells);
  EXPECT_EQ(saved(*third), saved(*second));
  EXPECT_LT(distance(third->pose().pose, drive(*third, room, RoomDrive::kLap / 2)), 0.1);
}

TEST(Session, OfAnotherKindIsRefusedAndAllStaysAsItIs) {
  const auto landmarks = madeFor(), grid = madeFor({true}),
             coarse = madeFor({true, BackendMode::kSlam, 0.1});
  SimulatedWorld world(10);
  drive(*landmarks, world, 20);
  RoomDrive room(10);
  drive(*grid, room, 20);
  const auto before = saved(*grid), of_landmarks = saved(*landmarks);
  const auto said = [&](GraphSlam& backend, const std::string& session) {
    return std::vector<std::string>{
        sentenceOf([&] { as<SessionKeeper>(backend).set(SavedSession{session}); })};
  };
  EXPECT_TRUE(test::oneSays(said(*grid, of_landmarks), {"has no grid", "map: landmarks"}));
  EXPECT_TRUE(test::oneSays(said(*landmarks, before), {"has a grid", "map: grid"}));
  EXPECT_TRUE(test::oneSays(said(*coarse, before), {"0.05 m", "0.1 m", "grid_map.resolution"}));
  grid->execute();
  EXPECT_EQ(saved(*grid), before);
}

/// Outside a back-end.
TEST(Session, CanBeOptimised) {
  const auto backend = madeFor();
  SimulatedWorld world(11);
  drive(*backend, world, SimulatedWorld::kLap);
  auto session = sessionOf(saved(*backend));
  auto graph = optimizerOf(session);
  EXPECT_TRUE(graph.optimize({}, 10));
  const auto before = session.nodes;
  follow(graph, session);
  ASSERT_EQ(session.nodes.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(distance(session.nodes[i], before[i]), 0.01);
  EXPECT_EQ(sessionOf(bytesOf(session)).nodes.size(), before.size());
}

}  // namespace
}  // namespace slam::graph_slam
