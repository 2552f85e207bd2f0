// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/line_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam {
namespace {

/// A wall 2 m to the left of the sensor, seen from 1 m behind it to 3 m ahead.
LandmarkObservation wallOnTheLeft() {
  LandmarkObservation z;
  z.range = 2.0;
  z.bearing = M_PI / 2;
  z.kind = LandmarkKind::kLine;
  z.extent = {-3.0, 1.0};
  return z;
}

TEST(LineModel, AWallOnTheLeftStandsThereWhereverTheRobotHasDriven) {
  const LineModel model(Pose2(), wallOnTheLeft());
  const auto m = model.invert(Pose2(), Pose2(), wallOnTheLeft().vector());
  EXPECT_NEAR(m.x(), 0.0, 1e-15) << "the anchor lies on the line";
  const auto z = model.predict(Pose2(7.0, 0.5, 0.1), Pose2(), m);
  EXPECT_NEAR(z.x(), 1.5, 1e-15) << "it does not matter how far along";
  EXPECT_NEAR(z.y(), M_PI / 2 - 0.1, 1e-15);
}

TEST(LineModel, AWallThroughTheOriginIsLikeAnyOther) {
  auto z = wallOnTheLeft();
  const Pose2 robot(0.0, -2.0, 0.0);
  const LineModel model(robot, z);
  const auto m = model.invert(robot, Pose2(), z.vector());
  EXPECT_LT((model.predict(robot, Pose2(), m) - z.vector()).norm(), 1e-15);
  const auto from_origin = LineModel(Eigen::Vector2d::Zero()).invert(robot, Pose2(), z.vector());
  EXPECT_NEAR(from_origin.x(), 0.0, 1e-15);
  EXPECT_NEAR(from_origin.y(), M_PI / 2, 1e-15);
}

TEST(LineModel, TheDirectionWrapsBehindTheRobot) {
  const LineModel model(Eigen::Vector2d(-2.0, 0.0));
  const auto nu = model.innovation({2.0, M_PI - 0.01}, {2.0, -M_PI + 0.02});
  EXPECT_NEAR(nu.y(), -0.03, 1e-12);
}

TEST(LineModel, TurnsWithTheMap) {
  const LineModel model(Eigen::Vector2d(5.0, 3.0));
  const Eigen::Vector2d m(0.2, 0.9);
  const Pose2 robot(1.0, -2.0, 0.4), turn(0.0, 0.0, 0.3);
  const auto before = model.predict(robot, Pose2(), m);
  const auto after = model.predict(turn * robot, Pose2(), model.turned(m, 0.3));
  EXPECT_LT((before - after).norm(), 1e-12);
  const Eigen::Vector2d numeric = (model.turned(m, 1e-6) - model.turned(m, -1e-6)) / 2e-6;
  EXPECT_LT((model.turnDerivative(m) - numeric).norm(), 1e-7);
}

TEST(LineModel, IsNotSeenFromBehind) {
  const LineModel model(Pose2(), wallOnTheLeft());
  const auto m = model.invert(Pose2(), Pose2(), wallOnTheLeft().vector());
  EXPECT_FALSE(model.isSingular(model.predict(Pose2(0, 1.9, 0), Pose2(), m)));
  EXPECT_TRUE(model.isSingular(model.predict(Pose2(0, 2.1, 0), Pose2(), m)));
}

TEST(LineModel, KnowsWhichPartOfItWasSeen) {
  const LineModel model(Pose2(), wallOnTheLeft());
  const auto m = model.invert(Pose2(), Pose2(), wallOnTheLeft().vector());
  const auto first = model.extentOf(Pose2(), wallOnTheLeft(), m);
  EXPECT_NEAR(first.begin, -2.0, 1e-12) << "from the middle";
  EXPECT_NEAR(first.end, 2.0, 1e-12);
  const auto ahead = model.extentOf(Pose2(5.0, 0.0, 0.0), wallOnTheLeft(), m);
  EXPECT_NEAR(ahead.begin, -7.0, 1e-12) << "what is ahead is on the right of who looks at the wall";
  EXPECT_NEAR(gapBetween(first, ahead), 1.0, 1e-12);
  EXPECT_NEAR(gapBetween(ahead, first), 1.0, 1e-12);
  EXPECT_LT(gapBetween(first, {1.0, 9.0}), 0.0);
  EXPECT_EQ(united(first, ahead).begin, ahead.begin);
  EXPECT_EQ(united(first, ahead).end, first.end);
}

TEST(LineModel, AMapTellsAPointOfItAndItsDirection) {
  const LineModel model(Pose2(), wallOnTheLeft());
  const auto landmark = model.landmarkOf(7, {0.1, M_PI / 2}, {-2.0, 2.0});
  EXPECT_EQ(landmark.id, 7);
  EXPECT_TRUE(landmark.isLine());
  EXPECT_LT((landmark.position - Eigen::Vector2d(1.0, 2.1)).norm(), 1e-12);
  EXPECT_NEAR(landmark.direction, M_PI / 2, 1e-15);
  EXPECT_EQ(landmark.extent.begin, -2.0);
}

}  // namespace
}  // namespace slam
