// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <functional>
#include <tuple>

#include "slam_core/product/test/grove.hpp"

namespace slam {
namespace {

using relocalisation::Belief;
using test::GroveRobot;

/// A robot that drives in a circle among trees that nobody can tell apart but by their places.
class LostByPlace : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  void SetUp() override {
    const auto& [backend, policy] = GetParam();
    robot.configure(backend, policy);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      robot.step();
      on_step();
    }
  }
  bool isSure() { return relocaliserOf(robot.estimator).belief() == Belief::kSure; }
  double error() const { return robot.error(); }

  static constexpr int kLap = GroveRobot::kLap;
  GroveRobot robot;
  std::function<void()> on_step = [] {};
};

TEST_P(LostByPlace, NoticesThatItWasCarriedAwayAndFindsItselfAgain) {
  drive(kLap + 40);
  ASSERT_TRUE(isSure());
  ASSERT_LT(error(), 0.3);
  robot.carry(100);
  int since = 0, lost = 0, wrong = 0;
  on_step = [&] {
    constexpr int kNoticed = 30;  // steps, 6 m
    lost += !isSure();
    wrong += ++since > kNoticed && isSure() && error() > 0.5;
  };
  drive(80);
  EXPECT_GT(lost, 0);
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(isSure());
  EXPECT_LT(error(), 0.5);
}

TEST_P(LostByPlace, IsNotLostOnLapsThatNothingDisturbs) {
  int lost = 0;
  on_step = [&] { lost += !isSure(); };
  drive(3 * kLap);
  EXPECT_EQ(lost, 0);
}

/// Where it is carried it has seen nothing since the session was loaded.
TEST(LostByPlace, FindsItselfWhereOnlyALoadedSessionHasBeen) {
  GroveRobot first, second;
  for (auto* robot : {&first, &second}) robot->configure("graph", "jcbb");
  first.drive(GroveRobot::kLap + 40);
  second.grove = first.grove;
  const auto session = first.estimator.capabilities().find<SessionKeeper>()->session();
  ASSERT_TRUE(second.estimator.startWith(session).isOk());
  second.drive(40);
  ASSERT_EQ(second.report.trust, Trust::kConfident);
  second.carry(100);
  second.drive(10);
  EXPECT_EQ(second.report.trust, Trust::kLost);
  second.drive(60);
  EXPECT_EQ(second.report.trust, Trust::kConfident);
  EXPECT_LT(second.error(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Policies, LostByPlace,
                         testing::Combine(testing::Values("ekf", "graph"),
                                          testing::Values("nearest", "jcbb")));

}  // namespace
}  // namespace slam
