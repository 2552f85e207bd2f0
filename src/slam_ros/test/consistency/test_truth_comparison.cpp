// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_ros/truth_comparison.hpp"

namespace slam_ros {
namespace {

slam::Stamp at(double seconds) {
  return slam::stampFromNanoseconds(static_cast<std::int64_t>(std::llround(1e9 * seconds)));
}

slam::PoseEstimate estimate(double x, double y, double theta) {
  return {slam::Pose2(x, y, theta), Eigen::Vector3d(0.01, 0.04, 0.0025).asDiagonal()};
}

/// The truth's frame lies elsewhere: the robot begins at (5, 1), heading along y, and drives ahead.
slam::Pose2 truth(double t) { return {5.0, 1.0 + t, M_PI_2}; }

struct TruthComparisonTest : ::testing::Test {
  void addTruth(double from, double to) {
    for (int i = 0; from + 0.1 * i <= to + 1e-9; ++i)
      comparison.add(at(from + 0.1 * i), truth(from + 0.1 * i));
  }
  TruthComparison comparison;
};

TEST_F(TruthComparisonTest, WeighsErrorsInTheMapFrameWithTheCovariance) {
  addTruth(0, 2);
  EXPECT_NEAR(*comparison.nees(at(0), estimate(0, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(*comparison.nees(at(1), estimate(1.1, 0.2, 0.05)), 3.0, 1e-9);
}

TEST_F(TruthComparisonTest, LooksBetweenTwoStamps) {
  addTruth(0, 2);
  comparison.nees(at(0), estimate(0, 0, 0));
  EXPECT_NEAR(*comparison.nees(at(1.234), estimate(1.334, 0, 0)), 1.0, 1e-9);
}

TEST_F(TruthComparisonTest, TakesHeadingsAsAngles) {
  addTruth(0, 1);
  comparison.nees(at(0), estimate(0, 0, M_PI));
  EXPECT_NEAR(*comparison.nees(at(1), estimate(-1, 0, 0.05 - M_PI)), 1.0, 1e-9);
}

TEST_F(TruthComparisonTest, SaysNothingOfWhatTheTruthDoesNotCover) {
  EXPECT_FALSE(comparison.nees(at(1), estimate(1, 0, 0)));
  EXPECT_FALSE(comparison.isExpected(at(1)));
  addTruth(0, 1);
  EXPECT_FALSE(comparison.nees(at(1.05), estimate(1, 0, 0)));
  EXPECT_TRUE(comparison.isExpected(at(1.05)));
  EXPECT_FALSE(comparison.isExpected(at(0.5))) << "it is here";
  EXPECT_FALSE(comparison.isExpected(at(5))) << "it has stopped";
  addTruth(3, 4);
  EXPECT_FALSE(comparison.nees(at(2), estimate(1, 0, 0))) << "a gap";
}

TEST_F(TruthComparisonTest, FindsTheFramesAgainWhenTheMapBeginsAnew) {
  addTruth(0, 2);
  comparison.nees(at(0), estimate(0, 0, 0));
  comparison.reset();
  EXPECT_NEAR(*comparison.nees(at(1), estimate(0, 0, 0)), 0.0, 1e-12);
}

TEST_F(TruthComparisonTest, BeginsAnewWhenTheTruthsStampsGoBack) {
  addTruth(5, 7);
  addTruth(0, 1);
  EXPECT_FALSE(comparison.nees(at(6), estimate(6, 0, 0)));
  EXPECT_TRUE(comparison.nees(at(0.5), estimate(0, 0, 0)));
}

}  // namespace
}  // namespace slam_ros
