// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/place_trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/relocalisation/test/map_alike.hpp"
#include "slam_core/scan_matching/drawn_grid.hpp"

namespace slam::relocalisation {
namespace {

using slam::test::RoomDrive;

constexpr double kMost = 9.0;

/// Scans of a robot in the room, and the map of another drive there.
class PlaceTrialTest : public testing::Test {
 protected:
  void SetUp() override {
    RoomDrive drive(1);
    for (int i = 0; i < RoomDrive::kLap; ++i) {
      const auto step = drive.next();
      const auto points = scan_matching::pointsOf(step.scan, models, 0.02);
      map.insert(points, step.truth);
    }
  }
  /// The next scan, some steps further.
  LocalScan next(int steps) {
    RoomDrive::Step step;
    for (int i = 0; i < steps; ++i) step = robot.next();
    return {scan_matching::pointsOf(step.scan, models, 0.02), step.truth, 0.0};
  }
  void drive(PlaceTrial& trial, int scans) {
    for (int i = 0; i < scans; ++i) trial.see(next(3), map.view(), matcher, kMost);
  }

  grid_map::GridMapConfig config;
  scan_matching::LevelModels models = scan_matching::levelModels(config);
  scan_matching::ScanMap map{config};
  scan_matching::ScanToMapMatcher matcher;
  RoomDrive robot{2};
};

TEST_F(PlaceTrialTest, WhatTheSearchHasUsedSaysNothing) {
  const PlaceTrial trial(Pose2(), {next(1)});
  EXPECT_EQ(trial.evidence(), 0.0);
}

TEST_F(PlaceTrialTest, WhatTheSearchHasUsedSpeaksAgainstAPlaceWhereMuchContradicts) {
  const auto against = [](int contradicting) {
    scan_matching::Agreement agreement;
    agreement.contradicting = contradicting;
    agreement.agreeing = 200 - contradicting;
    return PlaceTrial::evidenceAgainst(agreement);
  };
  EXPECT_EQ(against(0), 0.0);
  EXPECT_EQ(against(10), 0.0);
  EXPECT_LT(against(50), -1.0);
  EXPECT_LT(against(100), against(50) - 1.0);
  EXPECT_EQ(PlaceTrial::evidenceAgainst({}), 0.0);
}

TEST_F(PlaceTrialTest, NewSurfacesThatStandInTheMapSpeakForThePlace) {
  PlaceTrial trial(Pose2(), {next(1)});
  drive(trial, 12);
  EXPECT_GT(trial.evidence(), std::log(100.0));
}

/// The same scan again shows nothing new, however often it comes.
TEST_F(PlaceTrialTest, ARobotThatStandsLearnsNothing) {
  const auto scan = next(1);
  PlaceTrial trial(Pose2(), {scan});
  for (int i = 0; i < 1000; ++i) trial.see(scan, map.view(), matcher, kMost);
  EXPECT_LT(trial.evidence(), 0.1);
}

TEST_F(PlaceTrialTest, NewSurfacesThatAreMissingInTheMapRefuteAPlaceThatLooksAlike) {
  const auto first = robot.next();
  const auto grid = occupancyGridOf(map.finest().map, map.finest().model.resolution());
  const auto alike =
      scan_matching::drawn(slam::test::mapAlike(grid, first.scan, first.truth), config).map;
  PlaceTrial trial(Pose2(),
                   {{scan_matching::pointsOf(first.scan, models, 0.02), first.truth, 0.0}});
  for (int i = 0; i < 12; ++i) trial.see(next(3), alike->view(), matcher, kMost);
  EXPECT_LT(trial.evidence(), -std::log(100.0));
}

/// A person stands where the map is free.
TEST_F(PlaceTrialTest, APersonWhoStandsAroundDoesNotRefuteThePlace) {
  PlaceTrial trial(Pose2(), {next(1)});
  for (int i = 0; i < 12; ++i) {
    auto step = robot.next();
    for (auto& beam : step.scan.beams)
      if (std::abs(beam.bearing) < 0.2F) beam.range = std::min(beam.range, 1.2F);
    trial.see({scan_matching::pointsOf(step.scan, models, 0.02), step.truth, 0.0}, map.view(),
              matcher, kMost);
  }
  EXPECT_GT(trial.evidence(), 0.0);
}

TEST_F(PlaceTrialTest, AWrongPlaceInTheRoomIsRefuted) {
  PlaceTrial trial(Pose2(1.5, 0.8, 1.0), {next(1)});
  drive(trial, 12);
  EXPECT_LT(trial.evidence(), -std::log(100.0));
}

TEST_F(PlaceTrialTest, FollowsTheRobotThoughItsLocalPosesDrift) {
  PlaceTrial trial(Pose2(), {next(1)});
  Pose2 drifted;
  for (int i = 0; i < 20; ++i) {
    auto scan = next(3);
    drifted = drifted * Pose2(0.02, 0.01, 0.01);
    const Pose2 truth = scan.pose;
    scan.pose = drifted * scan.pose;
    trial.see(scan, map.view(), matcher, kMost);
    EXPECT_LT((trial.placeOf(scan.pose).position() - truth.position()).norm(), 0.1);
  }
  EXPECT_GT(trial.evidence(), std::log(100.0));
}

/// The scan as if its laser had seen the first half, and another one beside it the rest.
LaserScan ofTwoLasers(LaserScan scan) {
  const auto half = scan.beams.begin() + static_cast<std::ptrdiff_t>(scan.beams.size() / 2);
  LaserFan other = scan;
  other.sensor_pose = scan.sensor_pose * Pose2(0.1, 0.0, 0.0);
  other.beams.clear();
  for (auto beam = half; beam != scan.beams.end(); ++beam) {
    const Eigen::Vector2d end = beam->end() - Eigen::Vector2d(0.1, 0.0);
    other.beams.push_back({static_cast<float>(std::atan2(end.y(), end.x())),
                           static_cast<float>(end.norm()), beam->hit});
  }
  scan.beams.erase(half, scan.beams.end());
  scan.further.push_back(other);
  return scan;
}

TEST_F(PlaceTrialTest, TwoLasersTellWhatOneDoes) {
  const auto local = [this](const LaserScan& scan, const Pose2& pose) {
    return LocalScan{scan_matching::pointsOf(scan, models, 0.02), pose, 0.0};
  };
  const auto first = robot.next();
  PlaceTrial of_one(Pose2(), {local(first.scan, first.truth)});
  PlaceTrial of_two(Pose2(), {local(ofTwoLasers(first.scan), first.truth)});
  for (int i = 0; i < 4; ++i) {
    const auto step = robot.next();
    of_one.see(local(step.scan, step.truth), map.view(), matcher, kMost);
    of_two.see(local(ofTwoLasers(step.scan), step.truth), map.view(), matcher, kMost);
  }
  EXPECT_GT(of_one.evidence(), 0.5);
  EXPECT_NEAR(of_two.evidence(), of_one.evidence(), 0.1);
}

TEST_F(PlaceTrialTest, SumsUpNoMoreThanItIsTold) {
  PlaceTrial trial(Pose2(), {next(1)});
  drive(trial, 40);
  EXPECT_EQ(trial.evidence(), kMost);
}

}  // namespace
}  // namespace slam::relocalisation
