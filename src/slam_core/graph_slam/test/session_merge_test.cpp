// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

using test::RoomDrive;
using test::sentenceOf;
using test::SimulatedWorld;

/// A back-end that drives from where its world is now, which is the origin of its map.
struct MergedDrive {
  explicit MergedDrive(bool has_grid) {
    as<MapChooser>(*backend).useMap(has_grid ? MapKind::kGrid : MapKind::kLandmarks);
    backend->configure(GraphConfig());
  }
  void take(SimulatedWorld& world, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = world.next();
      backend->set(step.motion);
      backend->set(step.observations);
      const auto status = backend->execute();
      EXPECT_TRUE(status.isOk()) << status.message;
      truth = step.truth;
    }
  }
  void take(RoomDrive& room, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = room.next();
      give(step.motion, *backend);
      give(step.scan, *backend);
      backend->execute();
      truth = step.truth;
    }
  }
  Session session() const { return sessionOf(as<SessionKeeper>(*backend).session().bytes); }

  std::unique_ptr<GraphSlam> backend = std::make_unique<GraphSlam>();
  Pose2 truth;  ///< in the frame of the world
};

/// Leaves out steps of a drive. @return where it then is
template <class World>
Pose2 skip(World& world, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) truth = world.next().truth;
  return truth;
}

void expectNear(const Pose2& a, const Pose2& b, double distance, double angle) {
  const Pose2 error = a.between(b);
  EXPECT_LT(error.position().norm(), distance);
  EXPECT_LT(std::abs(error.theta()), angle);
}

void expectTruth(const Session& session, const SimulatedWorld& world) {
  EXPECT_EQ(session.landmarks.size(), world.landmarks().size());
  for (const auto& landmark : session.landmarks)
    EXPECT_LT((landmark.position - world.landmarks().at(landmark.id)).norm(), 0.15) << landmark.id;
}

/// Two nodes that lie a metre apart for sure, at headings that hardly anything tells, and a third
/// factor that sees the second one from the first, `seen` metres ahead.
Session tornApart(double seen) {
  const Eigen::Matrix3d W_place = Eigen::Vector3d(1e3, 1e3, 1e-2).asDiagonal();
  const Eigen::Matrix3d W_seen = Eigen::Vector3d(10.0, 10.0, 1e-2).asDiagonal();
  Session session;
  session.nodes = {{0.0, 0.0, 0.3}, {1.0, 0.0, 0.0}};
  session.factors = {Session::PosePrior{0, {0.0, 0.0, 0.0}, W_place},
                     Session::PosePrior{1, {1.0, 0.0, 0.0}, W_place},
                     Session::Between{0, 1, {seen, 0.0, 0.0}, W_seen}};
  return session;
}

TEST(Settle, BringsAGraphToRestWhoseFactorsContradictEachOtherALittle) {
  auto session = tornApart(1.5);
  settle(session);
  EXPECT_NEAR(session.nodes[0].theta(), 0.0, 1e-3);
}

/// Each step turns the first node by four times the error of its heading.
TEST(Settle, RefusesAGraphThatDoesNotComeToRest) {
  auto session = tornApart(4.0);
  const auto sentence = sentenceOf([&] { settle(session); });
  EXPECT_TRUE(test::oneSays({sentence}, {"does not come to rest", "the same place is none"}))
      << sentence;
}

/// Two drives past the same landmarks, the second one from elsewhere.
class DrivesPastLandmarks : public testing::Test {
 protected:
  DrivesPastLandmarks() {
    first.take(world, SimulatedWorld::kLap + 20);
    start = skip(again, 40);
    second.take(again, SimulatedWorld::kLap);
  }
  SimulatedWorld world{1}, again{2};
  MergedDrive first{false}, second{false};
  Pose2 start;  ///< of the second one
};

TEST_F(DrivesPastLandmarks, BecomeOneMapInTheFrameOfTheFirst) {
  const auto a = first.session(), b = second.session();
  const auto merged = graph_slam::merged(a, b, {}, GoesOn::kFirst);
  expectNear(merged.first_second, start, 0.1, 0.03);
  EXPECT_GE(merged.landmarks, 12u);
  EXPECT_EQ(merged.session.nodes.size(), a.nodes.size() + b.nodes.size());
  expectTruth(merged.session, world);
}

TEST_F(DrivesPastLandmarks, GoOnWithTheRobotThatIsAskedFor) {
  const auto a = first.session(), b = second.session();
  MergedDrive goes_on{false};
  as<SessionKeeper>(*goes_on.backend)
      .set({bytesOf(graph_slam::merged(a, b, {}, GoesOn::kSecond).session)});
  goes_on.take(again, SimulatedWorld::kLap);
  expectNear(goes_on.backend->pose().pose, again.next().truth, 0.3, 0.1);
  expectTruth(goes_on.session(), world);
  const auto by_first = graph_slam::merged(a, b, {}, GoesOn::kFirst).session;
  EXPECT_EQ(by_first.robot.node, a.robot.node);
  EXPECT_EQ(by_first.stamp, a.stamp);
}

TEST_F(DrivesPastLandmarks, AreMergedTheSameWayEachTime) {
  const auto a = first.session(), b = second.session();
  EXPECT_EQ(bytesOf(graph_slam::merged(a, b, {}, GoesOn::kSecond).session),
            bytesOf(graph_slam::merged(a, b, {}, GoesOn::kSecond).session));
}

TEST_F(DrivesPastLandmarks, LeaveOutATagThatWasMoved) {
  auto b = second.session();
  const auto before = b.landmarks.front();
  b.landmarks.front().position += Eigen::Vector2d(2.0, 1.0);
  const auto merged = graph_slam::merged(first.session(), b, {}, GoesOn::kFirst);
  expectTruth(merged.session, world);
  EXPECT_EQ(merged.session.landmarks.size(), world.landmarks().size()) << before.id;
}

TEST_F(DrivesPastLandmarks, HaveNothingInCommonWhereIdsDiffer) {
  auto b = second.session();
  for (auto& landmark : b.landmarks) landmark.id += 1000;
  const auto a = first.session();
  EXPECT_NE(
      sentenceOf([&] { graph_slam::merged(a, b, {}, GoesOn::kFirst); }).find("nothing in common"),
      std::string::npos);
}

TEST_F(DrivesPastLandmarks, AreNotMergedWithAGrid) {
  RoomDrive room(1);
  MergedDrive grid{true};
  grid.take(room, 20);
  EXPECT_NE(sentenceOf([&] {
              graph_slam::merged(first.session(), grid.session(), {}, GoesOn::kFirst);
            }).find("one session has a grid"),
            std::string::npos);
}

TEST_F(DrivesPastLandmarks, KeepALoadedMapAsTheFirst) {
  MergedDrive loaded{false};
  as<MapKeeper>(*loaded.backend).set(as<MapKeeper>(*first.backend).state());
  loaded.take(world, SimulatedWorld::kLap);
  EXPECT_NE(sentenceOf([&] {
              graph_slam::merged(first.session(), loaded.session(), {}, GoesOn::kFirst);
            }).find("give it as the first one"),
            std::string::npos);
}

TEST_F(DrivesPastLandmarks, AreMergedWhileTheFirstDrivesOn) {
  as<SessionMerger>(*first.backend).merge({bytesOf(second.session())});
  first.take(world, 3);
  EXPECT_EQ(first.backend->counters()["merged_sessions"], 1u);
  expectTruth(first.session(), world);
  EXPECT_GT(first.session().nodes.size(), second.session().nodes.size() + SimulatedWorld::kLap / 2);
  first.take(world, SimulatedWorld::kLap);
  EXPECT_EQ(first.backend->counters()["merged_sessions"], 1u);
  expectNear(first.backend->pose().pose, first.truth, 0.2, 0.06);
}

/// Two drives past trees that are told apart by their places alone.
class DrivesThroughAWood : public testing::Test {
 protected:
  static GraphConfig byPlace() {
    GraphConfig config;
    config.association = "jcbb";
    return config;
  }
  static std::map<LandmarkId, Eigen::Vector2d> trees() {
    RandomStream random(7, 0);
    std::map<LandmarkId, Eigen::Vector2d> places;
    while (places.size() < 24) {
      const Eigen::Vector2d place(16.0 * random.uniform() - 8.0, 16.0 * random.uniform() - 4.0);
      const auto is_near = [&](const auto& other) { return (other.second - place).norm() < 1.5; };
      const double from_way = std::abs((place - Eigen::Vector2d(0.0, 4.0)).norm() - 4.0);
      if (from_way > 0.7 && std::none_of(places.begin(), places.end(), is_near))
        places[static_cast<LandmarkId>(places.size())] = place;
    }
    return places;
  }
  DrivesThroughAWood() {
    first.backend->configure(byPlace());
    second.backend->configure(byPlace());
    first.take(world, SimulatedWorld::kLap + 20);
    start = skip(again, 40);
    second.take(again, SimulatedWorld::kLap);
  }
  /// Each tree is in the map once.
  void expectTrees(const Session& session) const {
    std::set<LandmarkId> ids, found;
    for (const auto& landmark : session.landmarks) {
      if (landmark.is_retired) continue;
      EXPECT_TRUE(ids.insert(landmark.id).second);
      for (const auto& [id, place] : world.landmarks())
        if ((landmark.position - place).norm() < 0.4) {
          EXPECT_TRUE(found.insert(id).second) << id;
        }
    }
    EXPECT_EQ(found.size(), ids.size());
    EXPECT_GE(found.size(), 15u);
  }
  SimulatedWorld world{1, trees()}, again{2, trees()};
  MergedDrive first{false}, second{false};
  Pose2 start;  ///< of the second one
};

TEST_F(DrivesThroughAWood, AreMergedByAConstellationAndNotByIds) {
  const auto a = first.session(), b = second.session();
  ASSERT_TRUE(a.kind.has_own_ids);
  const auto merged = graph_slam::merged(a, b, {}, GoesOn::kFirst);
  expectNear(merged.first_second, start, 0.2, 0.05);
  EXPECT_GE(merged.landmarks, 10u);
  expectTrees(merged.session);
}

TEST_F(DrivesThroughAWood, AreMergedWhileTheFirstDrivesOn) {
  as<SessionMerger>(*first.backend).merge({bytesOf(second.session())});
  first.take(world, 3);
  EXPECT_EQ(first.backend->counters()["merged_sessions"], 1u);
  first.take(world, SimulatedWorld::kLap);
  expectNear(first.backend->pose().pose, first.truth, 0.2, 0.06);
  expectTrees(first.session());
}

TEST_F(DrivesThroughAWood, AreNotMergedWithOneThatHasTheIdsOfMarkers) {
  SimulatedWorld markers(3);
  MergedDrive by_id{false};
  by_id.take(markers, 60);
  const auto a = first.session(), b = by_id.session();
  EXPECT_NE(sentenceOf([&] {
              graph_slam::merged(a, b, {}, GoesOn::kFirst);
            }).find("run both drives with the same association"),
            std::string::npos);
  EXPECT_NE(sentenceOf([&] {
              as<SessionMerger>(*first.backend).merge({bytesOf(b)});
            }).find("merge it in a product with association: known_ids"),
            std::string::npos);
  EXPECT_NE(sentenceOf([&] {
              as<SessionMerger>(*by_id.backend).merge({bytesOf(a)});
            }).find("ids of its own making"),
            std::string::npos);
}

/// The landmarks of this world lie on two circles, evenly: they look alike from each of eight
/// sides.
TEST(DrivesPastLandmarksThatLookAlike, AreNotMergedByConstellations) {
  SimulatedWorld world(1), again(2);
  MergedDrive first{false}, second{false};
  GraphConfig config;
  config.association = "jcbb";
  first.backend->configure(config);
  second.backend->configure(config);
  first.take(world, SimulatedWorld::kLap);
  second.take(again, SimulatedWorld::kLap);
  const auto a = first.session(), b = second.session();
  EXPECT_NE(
      sentenceOf([&] { graph_slam::merged(a, b, {}, GoesOn::kFirst); }).find("nothing in common"),
      std::string::npos);
}

/// The second part of the path has a prior of its own, in the second map.
TEST_F(DrivesPastLandmarks, KeepBothPartsOfAPathWhoseRobotWasPutElsewhere) {
  second.backend->set(second.backend->pose());
  second.take(again, 20);
  const auto b = second.session();
  const auto merged = graph_slam::merged(first.session(), b, {}, GoesOn::kSecond);
  EXPECT_EQ(merged.session.nodes.size(), first.session().nodes.size() + b.nodes.size());
  EXPECT_EQ(bytesOf(sessionOf(bytesOf(merged.session))), bytesOf(merged.session));
  expectTruth(merged.session, world);
  expectNear(merged.session.nodes.back(), second.truth, 0.2, 0.06);
}

TEST_F(DrivesPastLandmarks, OfOneTimeHaveOnePath) {
  const auto a = first.session(), b = second.session();
  EXPECT_EQ(graph_slam::merged(a, b, {}, GoesOn::kFirst).session.path.size(), a.path.size());
  EXPECT_EQ(graph_slam::merged(a, b, {}, GoesOn::kSecond).session.path.size(), b.path.size());
  auto later = b;
  for (auto& mark : later.path) mark.stamp += std::chrono::hours(1);
  const auto both = graph_slam::merged(a, later, {}, GoesOn::kSecond).session.path;
  ASSERT_EQ(both.size(), a.path.size() + b.path.size());
  for (std::size_t i = 1; i < both.size(); ++i) EXPECT_LT(both[i - 1].stamp, both[i].stamp);
}

TEST(DrivesThroughARoom, BecomeOneMapByTheirScans) {
  RoomDrive room(1), again(2);
  MergedDrive first{true}, second{true};
  first.take(room, RoomDrive::kLap);
  const Pose2 start = skip(again, 60);
  second.take(again, RoomDrive::kLap);
  const auto merged = graph_slam::merged(first.session(), second.session(), {}, GoesOn::kSecond);
  EXPECT_GE(merged.scans, 3u);
  expectNear(merged.first_second, start, 0.1, 0.03);
  MergedDrive goes_on{true};
  as<SessionKeeper>(*goes_on.backend).set({bytesOf(merged.session)});
  goes_on.take(again, 30);
  expectNear(goes_on.backend->pose().pose, goes_on.truth, 0.05, 0.02);
  const auto grid = as<GridMapper>(*goes_on.backend).grid();
  EXPECT_GT(test::shareOnWalls(*grid, room.room()), 0.9);
}

TEST(DrivesThroughARoom, KeepTheSecondMotionsToTheirNodes) {
  RoomDrive room(5), again(6);
  MergedDrive first{true}, second{true};
  const auto look = [](MergedDrive& drive, RoomDrive& through) {
    LandmarkObservationArray seen;
    for (const auto& place : {Eigen::Vector2d(3, 0.5), Eigen::Vector2d(0, 3)}) {
      seen.observations.push_back(through.sight(place.x() > 1.0 ? 1 : 2, place));
    }
    give(seen, *drive.backend);
    drive.backend->execute();
    drive.take(through, 1);
  };
  for (int i = 0; i < RoomDrive::kLap; ++i) look(first, room);
  for (int i = 0; i < RoomDrive::kLap; ++i) look(second, again);
  const auto a = first.session(), b = second.session();
  EXPECT_GT(b.chords.size(), 30u);
  const auto both = graph_slam::merged(a, b, {}, GoesOn::kSecond).session;
  EXPECT_EQ(both.chords.size(), a.chords.size() + b.chords.size());
  MergedDrive goes_on{true};
  as<SessionKeeper>(*goes_on.backend).set({bytesOf(both)});
  goes_on.take(again, 30);
  EXPECT_EQ(goes_on.session().chords.size(), both.chords.size());
  expectNear(goes_on.backend->pose().pose, goes_on.truth, 0.05, 0.02);
}

TEST(DrivesThroughARoom, AreMergedWhileOneDrives) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true};
  first.take(room, RoomDrive::kLap);
  const Pose2 start = skip(again, 60);
  running.take(again, 5);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, RoomDrive::kLap);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  expectNear(running.backend->pose().pose, start.between(running.truth), 0.06, 0.03);
  EXPECT_GT(running.session().scans.size(), first.session().scans.size());
}

TEST(DrivesThroughARoom, AreMergedByWhatTheRunningOneSawBefore) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true};
  first.take(room, RoomDrive::kLap);
  const Pose2 start = skip(again, 60);
  running.take(again, RoomDrive::kLap);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, 40);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  EXPECT_TRUE(as<SessionMerger>(*running.backend).unmerged().empty());
  expectNear(running.backend->pose().pose, start.between(running.truth), 0.06, 0.03);
}

TEST(DrivesThroughARoom, WaitOnAfterACheckpoint) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true}, restored{true};
  first.take(room, RoomDrive::kLap);
  running.take(again, 30);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, 3);
  ArchiveWriter writer;
  running.backend->saveState(writer);
  const auto state = writer.take();
  ArchiveReader reader(state);
  restored.backend->restoreState(reader);
  ASSERT_EQ(as<SessionMerger>(*restored.backend).unmerged().size(), 1u);
  auto rest = again;
  running.take(again, RoomDrive::kLap);
  restored.take(rest, RoomDrive::kLap);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  EXPECT_EQ(as<SessionKeeper>(*restored.backend).session().bytes,
            as<SessionKeeper>(*running.backend).session().bytes);
}

TEST_F(DrivesPastLandmarks, AreRefusedWhereTooManyWait) {
  auto& merger = as<SessionMerger>(*second.backend);
  for (int i = 0; i < 5; ++i) merger.merge({bytesOf(first.session())});
  EXPECT_NE(sentenceOf([&] { merger.merge({bytesOf(first.session())}); }).find("five sessions"),
            std::string::npos);
  EXPECT_EQ(merger.unmerged().size(), 5u);
}

TEST_F(DrivesPastLandmarks, AreMergedWithThoseOfABackEndMadeAlike) {
  const auto made = as<SessionMerger>(*first.backend).makeAlike();
  ASSERT_NE(made, nullptr);
  EXPECT_TRUE(as<LandmarkMapper>(*made).landmarks().empty());
  as<SessionMerger>(*first.backend).merge(as<SessionKeeper>(*made).session());
}

TEST(Session, IsMergedByNoBackEndWithAFixedMap) {
  GraphSlam fixed;
  GraphConfig config;
  config.mode = BackendMode::kLocalization;
  fixed.configure(config);
  EXPECT_EQ(as<SessionMerger>(fixed).makeAlike(), nullptr);
}

}  // namespace
}  // namespace slam::graph_slam
