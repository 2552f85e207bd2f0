// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using relocalisation::Belief;
using test::SimulatedStep;
using test::SimulatedWorld;

/// A lap with the map that comes of it, then a robot that is switched on somewhere on the way.
class Relocalisation : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    configure();
    for (int i = 0; i < 130; ++i) take(world.next());
    map = estimator.capabilities().find<MapKeeper>()->state();
  }
  void configure() {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void take(const SimulatedStep& step) {
    truth = step.truth;
    estimator.set(step.motion);
    estimator.set(step.observations);
    do {
      const auto of_step = estimator.execute();
      if (!estimator.report()) break;
      status = of_step;
      report = *estimator.report();
    } while (estimator.report());
  }
  /// Carries the robot on without its knowledge.
  void carry(int steps) {
    for (int i = 0; i < steps; ++i) truth = world.next().truth;
    estimator.intake().reset();
  }
  double error() const { return (report.pose.pose.position() - truth.position()).norm(); }
  double sigma() const { return std::sqrt(report.pose.covariance.topLeftCorner<2, 2>().trace()); }
  Belief belief() { return relocaliserOf(estimator).belief(); }

  SimulatedWorld world{1};
  Estimator estimator;
  MapState map;
  StepReport report;
  Status status;
  Pose2 truth;
};

TEST_P(Relocalisation, FindsARobotThatIsNotWhereItsMapWasSaved) {
  for (const int carried : {20, 50, 80}) {
    configure();
    ASSERT_NE(estimator.startWith(map).level, Status::Level::kError);
    carry(carried);
    take(world.next());
    EXPECT_GT(sigma(), 3.0);
    EXPECT_FALSE(status.isOk());
    for (int i = 0; i < 20; ++i) take(world.next());
    EXPECT_EQ(belief(), Belief::kSure);
    EXPECT_LT(error(), 0.3);
    EXPECT_LT(sigma(), 0.3);
    EXPECT_EQ(estimator.counters()["relocalised"], 1u);
  }
}

TEST_P(Relocalisation, KeepsTheSavedPoseWhereTheRobotIsThere) {
  configure();
  ASSERT_NE(estimator.startWith(map).level, Status::Level::kError);
  carry(0);
  for (int i = 0; i < 20; ++i) take(world.next());
  EXPECT_EQ(belief(), Belief::kSure);
  EXPECT_LT(error(), 0.3);
  EXPECT_EQ(estimator.counters()["relocalised"], 0u);
}

TEST_P(Relocalisation, BelievesAnInitialPose) {
  configure();
  estimator.startWith(map);
  estimator.set(PoseEstimate{truth, 1e-4 * Eigen::Matrix3d::Identity()});
  EXPECT_EQ(belief(), Belief::kSure);
  take(world.next());
  EXPECT_LT(sigma(), 0.3);
}

TEST_P(Relocalisation, FindsARobotThatWasCarriedAway) {
  carry(50);
  bool was_lost = false;
  for (int i = 0; i < 60; ++i) {
    take(world.next());
    was_lost |= belief() == Belief::kLost;
  }
  EXPECT_TRUE(was_lost);
  EXPECT_EQ(belief(), Belief::kSure);
  EXPECT_LT(error(), 0.4);
}

TEST_P(Relocalisation, LooksEverywhereWhenItIsAsked) {
  relocaliserOf(estimator).assume(Belief::kAnywhere);
  take(world.next());
  EXPECT_GT(sigma(), 3.0);
  for (int i = 0; i < 20; ++i) take(world.next());
  EXPECT_EQ(belief(), Belief::kSure);
  EXPECT_LT(error(), 0.3);
}

TEST_P(Relocalisation, WaitsForWhatIsInTheMap) {
  configure();
  estimator.startWith(map);
  carry(50);
  for (int i = 0; i < 30; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations) z.id += 1000;
    take(step);
  }
  EXPECT_EQ(belief(), Belief::kUnconfirmed);
  EXPECT_GT(sigma(), 3.0);
  EXPECT_GT(estimator.counters()["withheld"], 30u);
}

INSTANTIATE_TEST_SUITE_P(Backends, Relocalisation, testing::Values("ekf", "pf", "graph", "seif"));

TEST(RelocalisationWithoutAMap, HasNothingToLookFor) {
  Settings settings;
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  relocaliserOf(estimator).assume(Belief::kAnywhere);
  EXPECT_EQ(relocaliserOf(estimator).belief(), Belief::kSure);
}

}  // namespace
}  // namespace slam
