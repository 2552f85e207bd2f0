// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_track.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

Stamp after(double t) { return Stamp(std::chrono::seconds(10)) + durationFromSeconds(t); }

Motion motionOf(double start, double end, const Pose2& increment) {
  Motion motion;
  motion.start = after(start);
  motion.end = after(end);
  motion.increment = increment;
  motion.covariance = 0.01 * Eigen::Matrix3d::Identity();
  return motion;
}

TEST(MotionTrack, ComposesWhatLiesBetweenAndSplitsTheEnds) {
  MotionTrack track;
  for (int i = 0; i < 10; ++i) track.add(motionOf(0.1 * i, 0.1 * (i + 1), Pose2(0.02, 0.0, 0.0)));
  const auto gap = track.between(after(0.15), after(0.55));
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->increment.x(), 0.08, 1e-9);
  EXPECT_NEAR(gap->covariance(0, 0), 0.04, 1e-9);
}

TEST(MotionTrack, HasNothingToSayOfWhatItDoesNotCover) {
  MotionTrack track;
  EXPECT_FALSE(track.between(after(0.0), after(0.1)));
  track.add(motionOf(0.0, 0.1, Pose2()));
  track.add(motionOf(0.2, 0.3, Pose2()));
  EXPECT_FALSE(track.between(after(-0.1), after(0.05)));
  EXPECT_FALSE(track.between(after(0.05), after(0.25))) << "a hole";
  EXPECT_FALSE(track.between(after(0.25), after(0.35)));
  EXPECT_TRUE(track.between(after(0.2), after(0.3)));
}

}  // namespace
}  // namespace slam
