// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/mono_graph/test/picture_drive.hpp"

// Laps through a room: loops, honest covariances, robots that are carried.

namespace slam::mono_graph {
namespace {

using test::figureOf;
using test::PictureDrive;

TEST(MonoGraph, StaysWithTheRobotForTwoLapsAndClosesTheLoop) {
  PictureDrive drive(1);
  double worst = 0.0, nees = 0.0;
  const auto origin = [&] {
    return capabilitiesOf(drive.graph()).find<GraphReporter>()->graph().nodes.front().vector();
  };
  drive.step();
  const Eigen::Vector3d first = origin();
  const int steps = 2 * drive.round().stepsOfALap() - 1;
  for (int i = 0; i < steps; ++i) {
    const auto status = drive.step();
    EXPECT_TRUE(status.isOk()) << status.message;
    worst = std::max(worst, drive.error());
    nees += drive.nees() / steps;
  }
  EXPECT_LT(worst, 0.08);
  EXPECT_LT(nees, 4.0) << "the covariance is honest";
  EXPECT_GE(drive.graph().counters()["loops"], 1U);
  EXPECT_LT(figureOf(drive.graph(), "keyframes"), 110.0) << "the second lap needs hardly any";
  EXPECT_LT((origin() - first).norm(), 1e-6) << "the first keyframe is the origin of the map";
}

TEST(MonoGraph, KnowsThePlacesOfTheFirstLapAgain) {
  PictureDrive drive(2);
  const int lap = drive.round().stepsOfALap();
  drive.steps(2 * lap);
  const auto visits = capabilitiesOf(drive.graph()).find<PlaceReporter>()->visits();
  const auto path = capabilitiesOf(drive.graph()).find<PathReviser>()->path();
  ASSERT_EQ(visits.size(), static_cast<std::size_t>(2 * lap));
  ASSERT_EQ(path.size(), visits.size());
  EXPECT_LT((path.back().pose.vector() - drive.graph().pose().pose.vector()).norm(), 1e-9);
  int again = 0;
  for (int i = lap; i < 2 * lap; ++i) {
    const auto& visit = visits[static_cast<std::size_t>(i)];
    again += visit.first && *visit.first < visits[static_cast<std::size_t>(lap)].stamp ? 1 : 0;
  }
  EXPECT_GT(again, lap * 3 / 4);
}

TEST(MonoGraph, NoticesThatItWasCarriedAndFindsItself) {
  PictureDrive drive(3);
  drive.steps(130);
  drive.round().carry({0.6, 1.2, 2.4});
  bool was_lost = false;
  for (int i = 0; i < 25; ++i) {
    drive.step();
    was_lost = was_lost || drive.isLost();
    if (drive.isLost()) {
      EXPECT_GE(drive.graph().pose().covariance(0, 0), 1.0);
    }
  }
  EXPECT_TRUE(was_lost);
  EXPECT_FALSE(drive.isLost());
  EXPECT_LT(drive.error(), 0.1);
}

TEST(MonoGraph, IsNotPutBeforeTheWrongOneOfEqualWalls) {
  PictureDrive drive(3, {}, PictureDrive::Walls::kAlike);
  drive.steps(150);
  EXPECT_LT(drive.error(), 0.1) << "walls that look alike close no loop";
  drive.round().carry({0.6, 1.2, 2.4});
  for (int i = 0; i < 60; ++i) {
    drive.step();
    if (i < 10 || drive.isLost()) continue;
    EXPECT_LT(drive.error(), 0.3) << i;
  }
}

TEST(MonoGraph, StaysLostWhereItSeesWhatItNeverSaw) {
  PictureDrive drive(4), elsewhere(99);
  drive.steps(130);
  for (int i = 0; i < 20; ++i) {
    const auto motion = drive.round().drive();
    drive.inputs().set(motion);
    drive.inputs().set(elsewhere.round().room().view(motion.end, drive.round().place()));
    drive.graph().execute();
  }
  EXPECT_TRUE(drive.isLost());
  EXPECT_TRUE(drive.graph().pose().pose.isFinite());
}

TEST(MonoGraph, NoticesACameraThatWasTurnedByHand) {
  PictureDrive drive(11);
  drive.steps(130);
  const auto turned = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ());
  bool was_lost = false;
  for (int i = 0; i < 10; ++i) {
    const auto motion = drive.round().drive();
    const Pose2 looks = drive.round().place() * Pose2(0.0, 0.0, turned.angle());
    drive.inputs().set(motion);
    drive.inputs().set(drive.round().room().view(motion.end, looks));
    drive.graph().execute();
    was_lost = was_lost || drive.isLost();
  }
  EXPECT_TRUE(was_lost);
  EXPECT_TRUE(drive.graph().pose().pose.isFinite());
}

}  // namespace
}  // namespace slam::mono_graph
