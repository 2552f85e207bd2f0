// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/line_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::association {
namespace {

LandmarkObservation lineAt(double range, double bearing) {
  LandmarkObservation z;
  z.range = range;
  z.bearing = bearing;
  z.covariance = Eigen::Vector2d(1e-4, 1e-4).asDiagonal();
  z.kind = LandmarkKind::kLine;
  z.extent = {-1.0, 1.0};
  return z;
}

Motion motionBy(const Pose2& increment) {
  Motion motion;
  motion.increment = increment;
  motion.covariance = Eigen::Vector3d(1e-5, 1e-5, 1e-5).asDiagonal();
  return motion;
}

/// A robot that drives along two walls and turns.
TEST(LineTrials, ALineIsConfirmedWhenItHasStayedWhereItWas) {
  LineTrials trials(3);
  const Pose2 step(0.5, 0.1, 0.2), sensor(0.2, 0.0, 0.1);
  Pose2 robot;
  const LineModel wall(Eigen::Vector2d(2.0, 3.0));
  const Eigen::Vector2d left(0.0, M_PI / 2), ahead(4.0, 0.0);
  for (int i = 0; i < 4; ++i) {
    std::vector<LandmarkObservation> lines;
    for (const auto& m : {left, ahead}) {
      const auto z = wall.predict(robot, sensor, m);
      lines.push_back(lineAt(z.x(), z.y()));
    }
    trials.see(lines, sensor);
    for (const std::size_t line : {0, 1}) EXPECT_EQ(trials.isConfirmed(line), i >= 2) << i;
    EXPECT_EQ(trials.size(), 2u);
    trials.move(motionBy(step));
    robot = robot * step;
  }
}

TEST(LineTrials, WhatIsElsewhereEachTimeIsNotConfirmed) {
  LineTrials trials(2);
  for (int i = 0; i < 10; ++i) {
    trials.see({lineAt(2.0 + 0.2 * i, 0.0)}, Pose2());
    EXPECT_FALSE(trials.isConfirmed(0));
  }
}

TEST(LineTrials, TwoPartsOfALineAtOnceAreOneSighting) {
  LineTrials trials(3);
  for (int i = 0; i < 2; ++i) trials.see({lineAt(2.0, 0.0), lineAt(2.0, 0.0)}, Pose2());
  EXPECT_FALSE(trials.isConfirmed(0));
  trials.see({lineAt(2.0, 0.0)}, Pose2());
  EXPECT_TRUE(trials.isConfirmed(0));
}

TEST(LineTrials, ForgetWhatIsNotSeenAnyMore) {
  LineTrials trials(2);
  trials.see({lineAt(2.0, 0.0)}, Pose2());
  for (int i = 0; i < 30; ++i) trials.see({}, Pose2());
  EXPECT_EQ(trials.size(), 0u);
  for (int i = 0; i < 1500; ++i) trials.see({lineAt(1.0 + i, 1.0)}, Pose2());
  EXPECT_LE(trials.size(), 1000u);
}

}  // namespace
}  // namespace slam::association
