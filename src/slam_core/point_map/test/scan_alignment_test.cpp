// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/scan_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/point_map/test/room.hpp"

namespace slam::point_map {
namespace {

PointMapConfig loosePrior() {
  PointMapConfig config;
  config.prior_sigma_position = 10.0;
  config.prior_sigma_heading = 10.0;
  return config;
}

/// A map as it comes of looking around, without noise.
PointSet mapOf(const test::Room& room) {
  PointSet map;
  for (const auto& wall : room.walls())
    for (double way = 0; way < 1; way += 0.02 / (wall.to - wall.from).norm())
      map.append(wall.from + way * (wall.to - wall.from));
  return map;
}

double error(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

TEST(ScanAlignment, FindsThePoseFromAGuessNearby) {
  const test::Room room(6, 4);
  const auto map = mapOf(room);
  RandomStream random(1, 0);
  for (int i = 0; i < 50; ++i) {
    const Pose2 truth(1 + 4 * random.uniform(), 1 + 2 * random.uniform(), 6 * random.uniform());
    const auto scan = room.scan(truth, 0.005, &random);
    const Pose2 guess =
        truth * Pose2(0.08 * random.gaussian(), 0.08 * random.gaussian(), 0.03 * random.gaussian());
    const auto aligned = ScanAlignment(loosePrior()).align(scan, guess, guess, map);
    ASSERT_TRUE(aligned) << "pose " << i;
    EXPECT_LT(error(*aligned, truth), 0.01);
    EXPECT_LT(std::abs(std::remainder(aligned->theta() - truth.theta(), 2 * M_PI)), 0.004);
  }
}

TEST(ScanAlignment, AlongACorridorTheFiltersPoseCounts) {
  const test::Room room(200, 3);  // its ends are out of sight
  const auto map = mapOf(room);
  const Pose2 truth(100, 1.5, 0);
  const Pose2 prior(100.1, 1.55, 0.02);
  const auto aligned = ScanAlignment(PointMapConfig()).align(room.scan(truth), prior, prior, map);
  ASSERT_TRUE(aligned);
  EXPECT_NEAR(aligned->x(), 100.1, 0.01) << "the walls do not tell it";
  EXPECT_NEAR(aligned->y(), 1.5, 0.01);
  EXPECT_NEAR(aligned->theta(), 0.0, 0.003);
}

TEST(ScanAlignment, RefusesWhereTooLittleMeetsTheMap) {
  const test::Room room(6, 4);
  const auto map = mapOf(room);
  const auto scan = room.scan({3, 2, 0});
  EXPECT_FALSE(ScanAlignment(PointMapConfig()).align(scan, {30, 2, 0}, {30, 2, 0}, map));
  EXPECT_FALSE(ScanAlignment(PointMapConfig()).align(scan, {3, 2, 0}, {3, 2, 0}, PointSet()));
  EXPECT_FALSE(ScanAlignment(PointMapConfig()).align(LaserScan(), {3, 2, 0}, {3, 2, 0}, map));
}

}  // namespace
}  // namespace slam::point_map
