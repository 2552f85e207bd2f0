// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>

#include "slam_core/product/test/grove.hpp"

namespace slam {
namespace {

using test::GroveRobot;

/// A robot that drives in a circle among trees with ids.
class LostById : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { robot.configure(GetParam(), "known_ids"); }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      robot.step();
      lost += isLost() ? 1 : 0;
      wrong += !isLost() && robot.error() > 0.5 ? 1 : 0;
    }
  }
  bool isLost() const { return robot.report.trust == Trust::kLost; }

  static constexpr int kLap = GroveRobot::kLap;
  GroveRobot robot;
  int lost = 0, wrong = 0;  ///< steps; wrong without being lost
};

/// It is carried to where it has never been, so that all that it sees there is new.
TEST_P(LostById, NoticesThatItWasCarriedBeyondItsMap) {
  drive(kLap / 4);
  ASSERT_EQ(wrong, 0);
  ASSERT_EQ(lost, 0);
  robot.carry(80);
  drive(40);
  EXPECT_LE(wrong, 3) << "three views show it";
  EXPECT_TRUE(isLost());
  drive(kLap / 2);
  EXPECT_LE(wrong, 3);
  EXPECT_FALSE(isLost()) << "it is where its map began";
  for (const auto& landmark : robot.landmarks()) {
    const auto& tree = robot.grove.trees()[static_cast<std::size_t>(landmark.id)];
    EXPECT_LT((landmark.position - robot.start.inverse().transform(tree)).norm(), 0.5)
        << landmark.id;
  }
}

TEST_P(LostById, IsNotLostOnLapsThatNothingDisturbs) {
  drive(3 * kLap);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, LostById, testing::Values("ekf", "pf", "graph", "seif"));

}  // namespace
}  // namespace slam
