// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/relapses.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

class RelapsesTest : public testing::Test {
 protected:
  /// Lets so many seconds pass in steps of 0.1 s.
  void pass(double time, bool is_lost, double x = 0.0) {
    for (int i = 0; i < static_cast<int>(time * 10); ++i) {
      stamp_ += std::chrono::milliseconds(100);
      relapses.judge(is_lost, {x, 0.0}, stamp_);
    }
  }
  /// For how long a robot that stays found is on probation [s].
  double probation() {
    double time = 0.0;
    for (pass(0.1, false); relapses.isOnProbation() && time < 100.0; pass(0.1, false)) time += 0.1;
    return time;
  }

  Relapses relapses;

 private:
  Stamp stamp_ = stampFromNanoseconds(0);
};

TEST_F(RelapsesTest, TheFirstPlaceIsBelieved) {
  pass(10, false);
  pass(3, true);
  pass(1, false);
  EXPECT_FALSE(relapses.isOnProbation());
}

TEST_F(RelapsesTest, EachRelapseDoublesTheProbation) {
  pass(1, true);
  pass(1, false, 2.0);  // another place, so that there is hope
  for (const double expected : {1.0, 2.0, 4.0, 8.0}) {
    pass(1, true);
    EXPECT_NEAR(probation(), expected, 0.25);
  }
  EXPECT_EQ(relapses.count(), 4);
}

/// All landmarks have moved, and were learnt anew where a robot in doubt had them.
TEST_F(RelapsesTest, AfterTooManyOfThemTimeProvesNothing) {
  pass(1, true);
  for (int i = 0; i < Relapses::kHopeless; ++i) {
    pass(1, false);
    pass(1, true);
  }
  pass(3600, false);
  EXPECT_TRUE(relapses.isOnProbation());
  pass(1, true);
  pass(3600, false);
  EXPECT_TRUE(relapses.isOnProbation());
}

TEST_F(RelapsesTest, APlaceThatHasHeldForLongWasRight) {
  pass(1, true);
  pass(1, false);
  pass(1, true);
  pass(60, false);
  pass(1, true);
  pass(0.2, false);
  EXPECT_FALSE(relapses.isOnProbation());
}

TEST_F(RelapsesTest, TheirExtentIsTheLargestJumpWithWhichTheRobotWasFound) {
  pass(1, true, 0.0);
  pass(1, false, 0.1);
  EXPECT_DOUBLE_EQ(relapses.extent(), 0.5) << "at least";
  pass(1, true, 0.1);
  pass(0.2, false, 3.1);
  EXPECT_DOUBLE_EQ(relapses.extent(), 3.0);
}

}  // namespace
}  // namespace slam
