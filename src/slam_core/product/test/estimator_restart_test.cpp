// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/observation_intake.hpp"

namespace slam {
namespace {

Stamp stampOf(int tenths) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(100) * tenths;
}

class EstimatorRestartTest : public testing::Test {
 protected:
  EstimatorRestartTest() {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create("ekf"));
    estimator.configure(settings);
  }
  /// A step with the same landmarks each time, more of them than one step may add.
  /// @return how many were added
  int step(int tenths) {
    Motion motion;
    motion.sequence = static_cast<std::uint64_t>(tenths);
    motion.start = stampOf(tenths);
    motion.end = stampOf(tenths + 1);
    motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    estimator.set(motion);
    LandmarkObservationArray array;
    array.sequence = motion.sequence;
    array.stamp = motion.end;
    for (int id = 0; id < kLandmarks; ++id)
      array.observations.push_back({id, 5.0, 0.01 * id, 0.01 * Eigen::Matrix2d::Identity()});
    estimator.set(array);
    int added = 0;
    for (estimator.execute(); estimator.report(); estimator.execute())
      added += estimator.report()->statistics.added;
    return added;
  }

  static constexpr int kLandmarks = 300;
  static constexpr int kMost = ObservationIntake::kMostNewLandmarks;
  Estimator estimator;
};

TEST_F(EstimatorRestartTest, TheFirstStepAddsAsManyLandmarksAsThatOfAFreshStart) {
  for (const int begin : {100, 0}) {
    EXPECT_EQ(step(begin), kMost) << "from " << begin;
    EXPECT_EQ(step(begin + 1), kLandmarks - kMost) << "from " << begin;
    EXPECT_EQ(step(begin + 2), 0) << "from " << begin;
  }
  EXPECT_EQ(estimator.counters()["restart"], 1u);
}

TEST_F(EstimatorRestartTest, WhatComesWhilePausedIsNewLater) {
  estimator.pause(true);
  EXPECT_EQ(step(0), 0);
  estimator.pause(false);
  EXPECT_EQ(step(1), kMost) << "nothing of the paused step is known";
}

}  // namespace
}  // namespace slam
