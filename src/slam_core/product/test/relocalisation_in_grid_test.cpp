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

/// A robot that maps a hall, and goes on in a passage, where the map has nothing to contradict.
class CarriedWithALaser : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings({}, {}, {"backend=" + GetParam(), "map=grid", "odometry=wheel"});
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void drive(const test::EmptyRoom& room, int steps) {
    for (int i = 0; i < steps; ++i) {
      Motion motion;
      motion.start = stamp;
      motion.end = stamp += std::chrono::milliseconds(100);
      motion.increment = Pose2(0.05, 0.0, 0.01);
      motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
      motion.odometry_start = odometry;
      motion.odometry_end = odometry = odometry * motion.increment;
      estimator.set(motion);
      estimator.set(room.scanFrom(odometry, stamp));
      for (estimator.execute(); estimator.report(); estimator.execute())
        trust = estimator.report()->trust;
    }
  }
  std::vector<std::int8_t> cells() {
    return estimator.capabilities().find<GridMapper>()->grid()->cells;
  }

  Estimator estimator;
  Stamp stamp = stampFromNanoseconds(1000000000000);
  Pose2 odometry;
  Trust trust = Trust::kUnknown;
};

TEST_P(CarriedWithALaser, IsLostAtOnceAndDrawsNothing) {
  drive({10.0, 8.0}, 40);
  EXPECT_EQ(trust, Trust::kConfident);
  const auto before = cells();
  drive({16.0, 3.0}, 3);
  EXPECT_EQ(trust, Trust::kLost);
  drive({16.0, 3.0}, 40);
  EXPECT_EQ(trust, Trust::kLost);
  EXPECT_TRUE(cells() == before);
  EXPECT_EQ(estimator.counters()["unlike_last"], 3u);
}

INSTANTIATE_TEST_SUITE_P(Backends, CarriedWithALaser, testing::Values("grid", "pf", "graph"));

}  // namespace
}  // namespace slam
