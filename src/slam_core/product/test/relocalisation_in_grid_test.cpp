// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/relocalisation/test/map_alike.hpp"
#include "slam_core/relocalisation/test/scan_of_room.hpp"

namespace slam {
namespace {

using relocalisation::Belief;
using test::RoomDrive;

/// A robot with a laser in a room, of which it has a map.
class RelocalisationInGrid : public testing::Test {
 protected:
  void SetUp() override {
    configure({});
    RoomDrive drive(1);
    for (int i = 0; i < RoomDrive::kLap; ++i) take(drive.next());
    map = estimator.capabilities().find<MapKeeper>()->state();
    map.robot.pose = {};
    configure({"grid.mode=localization"});
  }
  void configure(std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"backend=grid", "map=grid", "odometry=wheel"});
    Settings settings({}, {}, overrides);
    estimator.use(Registry<Backend>::instance().create("grid"));
    estimator.configure(settings);
  }
  void take(const RoomDrive::Step& step) {
    estimator.set(step.motion);
    estimator.set(step.scan);
    do estimator.execute();
    while (estimator.report());
  }
  Belief belief() { return relocaliserOf(estimator).belief(); }
  std::uint64_t count(const std::string& name) { return estimator.counters()[name]; }

  Estimator estimator;
  MapState map;
  RoomDrive robot{2};
};

TEST_F(RelocalisationInGrid, BelievesTheSavedPoseWithTheFirstScansThere) {
  estimator.startWith(map);
  for (int i = 0; i < 3; ++i) take(robot.next());
  EXPECT_EQ(belief(), Belief::kSure);
  for (int i = 0; i < 150; ++i) take(robot.next());
  EXPECT_EQ(belief(), Belief::kSure);
  EXPECT_EQ(count("withdrawn"), 0u);
}

/// The first scan fits the map, what comes next does not.
TEST_F(RelocalisationInGrid, WithdrawsAPlaceThatTheNextScansRefute) {
  const auto first = robot.next();
  map.grid = test::mapAlike(*map.grid, first.scan, first.truth);
  estimator.startWith(map);
  take(first);
  take(robot.next());
  ASSERT_EQ(belief(), Belief::kSure);
  for (int i = 0; i < 40; ++i) take(robot.next());
  EXPECT_EQ(belief(), Belief::kLost);
  EXPECT_EQ(count("withdrawn"), 1u);
}

/// A robot maps a room with a laser, and finds itself in a lobby.
class CarriedWithALaser : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings({}, {}, {"backend=" + GetParam(), "map=grid", "odometry=wheel"});
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void take(const RoomDrive::Step& step) {
    estimator.set(step.motion);
    estimator.set(step.scan);
    said.clear();
    for (auto status = estimator.execute(); estimator.report(); status = estimator.execute()) {
      trust = estimator.report()->trust;
      doubt = estimator.report()->doubt;
      said += status.message;
    }
  }
  RoomDrive::Step next() {
    auto step = robot.next();
    for (auto* stamp : {&step.motion.start, &step.motion.end, &step.scan.stamp}) *stamp -= carried;
    return step;
  }
  void driveInRoom(int steps) {
    for (int i = 0; i < steps; ++i) take(next());
  }
  /// The robot goes on where it would have been so many steps later.
  void carryOn(int steps) {
    for (int i = 0; i < steps; ++i) where = robot.next().truth;
    carried += steps * robot.interval;
  }
  /// Somebody stands close before the laser, and hides an arc of 36 degrees.
  void driveWithSomebody(int steps, std::size_t first_beam) {
    for (int i = 0; i < steps; ++i) {
      auto step = next();
      for (std::size_t beam = first_beam; beam < first_beam + 36; ++beam)
        step.scan.beams[beam].range = 0.5F;
      take(step);
    }
  }
  /// @param moved how far the robot is in the lobby at first [m]
  void driveInLobby(int steps, double moved = 0.0) {
    for (int i = 0; i < steps; ++i) {
      auto step = next();
      step.motion.increment = Pose2(0.05, 0.0, 0.0);
      const Pose2 in_lobby(moved + 0.05 * i - 1.5, 0.2, 0.0);
      const auto seen = test::CoarseLaser().scanOf(lobby, in_lobby * step.scan.sensor_pose);
      step.scan.beams = seen.beams;
      take(step);
    }
  }
  std::vector<std::int8_t> cells() {
    return estimator.capabilities().find<GridMapper>()->grid()->cells;
  }

  Estimator estimator;
  const test::Room lobby{4.0, 14.0};
  RoomDrive robot{3};
  Pose2 where;          ///< T_map_base after carryOn()
  Duration carried{0};  ///< the stamps that were left out
  Trust trust = Trust::kUnknown;
  std::string doubt, said;
};

TEST_P(CarriedWithALaser, IsLostAtTheFourthScanThereAndDrawsNothing) {
  driveInRoom(80);
  EXPECT_EQ(trust, Trust::kConfident);
  const auto before = cells();
  driveInLobby(3);
  EXPECT_NE(trust, Trust::kLost);
  driveInLobby(1, 0.15);
  EXPECT_EQ(trust, Trust::kLost);
  EXPECT_NE(said.find("what its laser sees has changed at once"), std::string::npos) << said;
  EXPECT_EQ(doubt, "what the laser sees has changed at once");
  driveInLobby(40, 0.2);
  EXPECT_EQ(trust, Trust::kLost);
  EXPECT_TRUE(cells() == before);
  EXPECT_EQ(estimator.counters()["unlike_last"], 4u);
}

TEST_P(CarriedWithALaser, IsFoundWhereItsMapIs) {
  driveInRoom(RoomDrive::kLap);
  driveInLobby(20);
  ASSERT_EQ(trust, Trust::kLost);
  driveInRoom(2 * RoomDrive::kLap);
  EXPECT_EQ(trust, Trust::kConfident);
  EXPECT_EQ(estimator.counters()["relocalised"], 1u) << "it does not stay at the wrong pose";
}

TEST_P(CarriedWithALaser, IsNotLostWhereSomebodyHasPutIt) {
  driveInRoom(RoomDrive::kLap);
  carryOn(40);
  estimator.set(PoseEstimate{where, 1e-4 * Eigen::Matrix3d::Identity()});
  for (int i = 0; i < 20; ++i) {
    driveInRoom(1);
    EXPECT_NE(trust, Trust::kLost) << i;
  }
  EXPECT_EQ(estimator.counters()["unlike_last"], 0u);
}

/// Two fifths of the view change at once, and the rest fits the map.
TEST_P(CarriedWithALaser, IsNotTakenForCarriedWhenSomebodyMovesBeforeIt) {
  driveWithSomebody(80, 50);
  for (int i = 0; i < 20; ++i) {
    driveWithSomebody(1, 90);
    EXPECT_NE(trust, Trust::kLost) << i;
  }
  EXPECT_GT(estimator.counters()["unlike_last"], 2u);
}

INSTANTIATE_TEST_SUITE_P(Backends, CarriedWithALaser, testing::Values("grid", "pf", "graph"));

}  // namespace
}  // namespace slam
