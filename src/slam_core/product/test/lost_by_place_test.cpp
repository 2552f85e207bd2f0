// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <functional>
#include <tuple>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/test/grove.hpp"

namespace slam {
namespace {

using relocalisation::Belief;
using test::Grove;

class LostByPlace : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  void SetUp() override {
    const auto& [backend, policy] = GetParam();
    Settings settings({}, {}, {"association=" + policy});
    estimator.use(Registry<Backend>::instance().create(backend));
    estimator.configure(settings);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      estimator.set(grove.drive());
      estimator.set(grove.look());
      while (true) {
        estimator.execute();
        if (!estimator.report()) break;
        report = *estimator.report();
      }
      on_step();
    }
  }
  /// Lifts the robot, and puts it down elsewhere on its way.
  void carry(int steps) { grove.truth = grove.truth * Pose2::exp(steps * kStep); }
  bool isSure() { return relocaliserOf(estimator).belief() == Belief::kSure; }
  double error() const {
    const Pose2 in_map = kStart.inverse() * grove.truth;
    return (report.pose.pose.position() - in_map.position()).norm();
  }

  const Eigen::Vector3d kStep{0.2, 0.0, 0.025};
  const Pose2 kStart{15.0, 7.0, 0.0};
  static constexpr int kLap = 252;  // steps
  Grove grove{1};
  Estimator estimator;
  StepReport report;
  std::function<void()> on_step = [] {};
};

TEST_P(LostByPlace, NoticesThatItWasCarriedAwayAndFindsItselfAgain) {
  drive(kLap + 40);
  ASSERT_TRUE(isSure());
  ASSERT_LT(error(), 0.3);
  carry(100);
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

INSTANTIATE_TEST_SUITE_P(Policies, LostByPlace,
                         testing::Combine(testing::Values("ekf", "graph"),
                                          testing::Values("nearest", "jcbb")));

}  // namespace
}  // namespace slam
