// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/gating_rate.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

/// Each of these landmarks is seen at each step and gated with its own probability.
class GatingRateTest : public testing::Test {
 protected:
  void see(const std::vector<double>& gated) {
    UpdateStatistics statistics;
    statistics.gate_probability = gate_probability;
    for (std::size_t i = 0; i < gated.size(); ++i) {
      ObservationInnovation innovation;
      innovation.id = static_cast<LandmarkId>(i);
      innovation.used = random_.uniform() >= gated[i];
      statistics.innovations.push_back(innovation);
    }
    rate.add(statistics);
  }
  /// The number of steps after which the rate was excessive.
  int alarms(const std::vector<double>& gated, int steps) {
    int alarms = 0;
    for (int i = 0; i < steps; ++i) {
      see(gated);
      alarms += rate.isExcessive() ? 1 : 0;
    }
    return alarms;
  }

  GatingRate rate{50};
  double gate_probability = 0.9999;

 private:
  RandomStream random_{11, 0};
};

TEST_F(GatingRateTest, CountsTheWindow) {
  for (int i = 0; i < 60; ++i) see({0.0, 1.0});
  EXPECT_EQ(rate.observations(), 100);
  EXPECT_EQ(rate.gated(), 50);
}

TEST_F(GatingRateTest, IsExcessiveWhereMostIsGated) {
  EXPECT_EQ(alarms(std::vector<double>(8, 0.0), 200), 0);
  int steps = 0;
  while (!rate.isExcessive() && steps < 100) {
    see(std::vector<double>(8, 0.95));
    ++steps;
  }
  EXPECT_LE(steps, 32) << "half of the window and a little more";
}

/// 30 000 windows in which every fifth reading is wrong.
TEST_F(GatingRateTest, GivesNoFalseAlarmWhereEveryFifthReadingIsWrong) {
  for (const std::size_t landmarks : {1, 2, 8})
    EXPECT_EQ(alarms(std::vector<double>(landmarks, 0.2), 10000), 0) << landmarks;
}

TEST_F(GatingRateTest, TakesALandmarkThatWasMovedForNoLostPose) {
  EXPECT_EQ(alarms({1.0}, 300), 0) << "the only one in view";
  EXPECT_EQ(alarms({1.0, 0.0}, 300), 0);
  EXPECT_EQ(alarms({1.0, 1.0, 0.0, 0.0, 0.0}, 300), 0);
}

TEST_F(GatingRateTest, TakesASingleImageForNoLostPose) {
  for (int i = 0; i < 40; ++i) see({0.0});
  see(std::vector<double>(60, 1.0));
  EXPECT_GT(2 * rate.gated(), rate.observations());
  EXPECT_FALSE(rate.isExcessive());
}

TEST_F(GatingRateTest, KnowsHowOftenRightObservationsFailANarrowGate) {
  gate_probability = 0.4;
  EXPECT_EQ(alarms(std::vector<double>(8, 0.6), 5000), 0);
  gate_probability = 0.9999;
  EXPECT_GT(alarms(std::vector<double>(8, 0.6), 5000), 4000);
}

TEST_F(GatingRateTest, PassesOverStepsWithoutKnownLandmarks) {
  see(std::vector<double>(4, 1.0));
  for (int i = 0; i < 200; ++i) rate.add(UpdateStatistics());
  EXPECT_EQ(rate.observations(), 4);
}

TEST_F(GatingRateTest, ForgetsOnceObservationsFitAgain) {
  EXPECT_GT(alarms(std::vector<double>(6, 1.0), 50), 0);
  for (int i = 0; i < 50; ++i) see(std::vector<double>(6, 0.0));
  EXPECT_EQ(rate.gated(), 0);
  EXPECT_FALSE(rate.isExcessive());
}

}  // namespace
}  // namespace slam
