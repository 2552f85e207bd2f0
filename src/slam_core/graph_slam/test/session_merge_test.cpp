// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/graph_slam/test/merged_drive.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

using test::DrivesPastLandmarks;
using test::expectNear;
using test::expectTruth;
using test::MergedDrive;
using test::RoomDrive;
using test::sentenceOf;
using test::SimulatedWorld;
using test::skip;

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

}  // namespace
}  // namespace slam::graph_slam
