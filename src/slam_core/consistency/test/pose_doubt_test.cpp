// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/pose_doubt.hpp"

#include <gtest/gtest.h>

#include "slam_core/models/test/simulated_world.hpp"

namespace slam {
namespace {

/// The robot is carried on by a step each two metres. The landmarks in view show that, too.
TEST(PoseDoubt, TakesARelocationForNoMotion) {
  constexpr int kSteps = 100, kBetween = 10;
  test::SimulatedWorld world(1);
  PoseDoubt doubt;
  for (int i = 0; i < kSteps; ++i) {
    const auto step = world.next();
    if (i % kBetween == kBetween - 1) {
      doubt.relocate(step.truth);
      continue;  // the wheels have not turned
    }
    doubt.predict(step.motion);
    doubt.see(step.observations);
    doubt.compare(step.truth);
  }
  const auto P = doubt.covarianceAt(Pose2(5.0, 0.0, 0.0), false);
  EXPECT_TRUE(P.isZero()) << P;
}

}  // namespace
}  // namespace slam
