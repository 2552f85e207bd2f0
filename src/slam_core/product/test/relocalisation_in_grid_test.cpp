// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/relocalisation/test/map_alike.hpp"

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

}  // namespace
}  // namespace slam
