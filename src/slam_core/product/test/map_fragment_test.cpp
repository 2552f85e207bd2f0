// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_fragment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/product/test/grove.hpp"

namespace slam {
namespace {

constexpr int kLap = test::GroveRobot::kLap, kMapped = 100;    // steps
constexpr int kCarried = 40, kLost = 80;                       // steps
constexpr int kBack = kLap - kMapped - kCarried - kLost + 95;  // until shortly before the carry

/// A robot that maps the beginning of a circle, is carried on to where it has never been, and
/// drives back to the beginning.
struct CarriedRobot : test::GroveRobot {
  explicit CarriedRobot(const std::string& backend) { configure(backend, "jcbb"); }
  /// Drives until it is lost where it has mapped nothing.
  void loseItself() {
    drive(kMapped);
    carry(kCarried);
    drive(kLost);
    ASSERT_EQ(report.trust, Trust::kLost);
  }
  std::vector<SavedSession> unmerged() const {
    return estimator.capabilities().find<MapFragment>()->unmerged();
  }
  std::uint64_t count(const std::string& name) const { return estimator.counters()[name]; }
};

/// @return how far the map's worst landmark is from the nearest tree [m]
double worstOf(const CarriedRobot& robot) {
  double worst = 0.0;
  for (const auto& landmark : robot.landmarks()) {
    double nearest = INFINITY;
    for (const auto& tree : robot.grove.trees())
      nearest =
          std::min(nearest, (robot.start.inverse().transform(tree) - landmark.position).norm());
    worst = std::max(worst, nearest);
  }
  return worst;
}

/// @return how many landmarks lie around the middle of the way that the robot was lost on
auto landmarksWhereItWasLost(const CarriedRobot& robot) {
  const Pose2 middle =
      Pose2::exp((kMapped + kCarried + kLost / 2) * Eigen::Vector3d(0.2, 0, 0.025));
  const auto map = robot.landmarks();
  return std::count_if(map.begin(), map.end(), [&](const Landmark& landmark) {
    return (landmark.position - middle.position()).norm() < 4.0;
  });
}

TEST(MapFragment, BecomesPartOfTheMapWhenTheRobotIsFound) {
  CarriedRobot robot("graph");
  robot.loseItself();
  EXPECT_EQ(robot.unmerged().size(), 1u);
  EXPECT_EQ(landmarksWhereItWasLost(robot), 0);
  robot.drive(kBack);
  EXPECT_EQ(robot.report.trust, Trust::kConfident);
  EXPECT_EQ(robot.count("map_fragments"), 1u);
  EXPECT_EQ(robot.count("merged_sessions"), 1u);
  EXPECT_TRUE(robot.unmerged().empty());
  EXPECT_GE(landmarksWhereItWasLost(robot), 2);
  EXPECT_LT(worstOf(robot), 0.5);
  EXPECT_LE(robot.landmarks().size(), robot.grove.trees().size());
}

TEST(MapFragment, GoesOnAfterACheckpoint) {
  CarriedRobot robot("graph"), restored("graph");
  robot.loseItself();
  ArchiveWriter writer;
  robot.estimator.saveState(writer);
  const auto state = writer.take();
  ArchiveReader reader(state);
  restored.estimator.restoreState(reader);
  restored.grove = robot.grove;
  for (auto* each : {&robot, &restored}) each->drive(kBack);
  EXPECT_EQ(restored.count("merged_sessions"), 1u);
  ArchiveWriter of_robot, of_restored;
  robot.estimator.saveState(of_robot);
  restored.estimator.saveState(of_restored);
  EXPECT_EQ(of_restored.take(), of_robot.take());
}

TEST(MapFragment, IsNotMergedWhereSomebodyPutsTheRobotElsewhere) {
  CarriedRobot robot("graph");
  robot.loseItself();
  PoseEstimate place;
  place.pose = robot.inMap(robot.grove.truth);
  place.covariance = 0.01 * Eigen::Matrix3d::Identity();
  robot.estimator.set(place);
  robot.drive(kBack);
  EXPECT_EQ(robot.count("map_fragments"), 0u);
  EXPECT_EQ(robot.unmerged().size(), 1u) << "it is kept all the same";
  robot.estimator.reset();
  EXPECT_TRUE(robot.unmerged().empty());
}

TEST(MapFragment, IsThrownAwayWhereTheRobotIsFoundSoon) {
  CarriedRobot robot("graph");
  robot.drive(kLap + 40);
  robot.carry(100);
  robot.drive(120);
  EXPECT_EQ(robot.report.trust, Trust::kConfident);
  EXPECT_GT(robot.count("relocalised"), 0u);
  EXPECT_EQ(robot.count("map_fragments"), 0u);
  EXPECT_TRUE(robot.unmerged().empty());
}

TEST(MapFragment, IsNoneOfABackEndThatMergesNone) {
  CarriedRobot robot("ekf");
  robot.loseItself();
  EXPECT_TRUE(robot.unmerged().empty());
}

}  // namespace
}  // namespace slam
