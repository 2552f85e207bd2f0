// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/map_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::scan_matching {
namespace {

const Eigen::Matrix3d kFirst = 1e-6 * Eigen::Matrix3d::Identity();

/// A map that was drawn along a straight line, a part each half metre.
MapDrift drawnAlong(double metres) {
  MapDrift drift(0.01, 0.002);
  drift.restart({Pose2(), kFirst});
  for (double x = 0.5; x <= metres; x += 0.5) drift.add(Pose2(x, 0.0, 0.0));
  return drift;
}

TEST(MapDrift, GrowsWithTheWayIntoTheUnknown) {
  const auto drift = drawnAlong(100.0);
  EXPECT_EQ(drift.covarianceAt(Pose2()), kFirst);
  const auto P = drift.covarianceAt(Pose2(100.0, 0.0, 0.0));
  // 0.01 m and 0.002 rad after a metre, with the root of the way
  EXPECT_NEAR(std::sqrt(P(0, 0)), 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(P(2, 2)), 0.02, 0.002);
  // across, the heading's error adds up: sigma d sqrt(d / 3)
  EXPECT_NEAR(std::sqrt(P(1, 1)), 0.002 * 100.0 * std::sqrt(100.0 / 3.0), 0.12);
}

TEST(MapDrift, IsAsSureAsBeforeWhereTheRobotComesBack) {
  auto drift = drawnAlong(50.0);
  const auto before = drift.covarianceAt(Pose2(10.0, 0.0, 0.0));
  for (double y = 0.5; y <= 30.0; y += 0.5) drift.add(Pose2(50.0, y, 0.0));
  drift.add(Pose2(10.0, 0.2, 3.0));  // again there, after a long way
  const auto after = drift.covarianceAt(Pose2(10.0, 0.1, 3.0));
  EXPECT_NEAR(after(0, 0), before(0, 0), 0.2 * before(0, 0));
}

TEST(MapDrift, WhatBeginsAnewIsNoSurerNearOlderParts) {
  auto drift = drawnAlong(5.0);
  drift.restart({Pose2(4.0, 0.0, 0.0), Eigen::Matrix3d::Identity()});
  EXPECT_GE(drift.covarianceAt(Pose2(3.0, 0.0, 0.0))(0, 0), 1.0);
}

TEST(MapDrift, ALoadedMapIsTheReference) {
  MapDrift drift(0.0, 0.0);
  drift.restart({Pose2(3.0, 4.0, 1.0), Eigen::Matrix3d::Zero()});
  EXPECT_LT(drift.covarianceAt(Pose2(30.0, 4.0, 0.0)).norm(), 1e-12);
}

TEST(MapDrift, IsSurerThanARobotThatIsVagueAndVaguerThanTheParts) {
  MapDrift drift(0.01, 0.002);
  const auto robot = [](double sigma) {
    return PoseEstimate{Pose2(), sigma * sigma * Eigen::Matrix3d::Identity()};
  };
  drift.restart(robot(0.01));
  EXPECT_TRUE(drift.isSurerThan(robot(0.3)));
  EXPECT_FALSE(drift.isSurerThan(robot(0.05))) << "it is not vague";
  drift.restart(robot(1.0));
  EXPECT_FALSE(drift.isSurerThan(robot(0.3))) << "the parts are vaguer";
}

}  // namespace
}  // namespace slam::scan_matching
