// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::SimulatedWorld;

class EstimatorDeadReckoning : public testing::Test {
 protected:
  void SetUp() override {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create("ekf"));
    estimator.configure(settings);
  }
  void drive(int steps, bool sees_landmarks) {
    for (int i = 0; i < steps; ++i) {
      auto step = world.next();
      if (!sees_landmarks) step.observations.observations.clear();
      estimator.set(step.motion);
      estimator.set(step.observations);
      do {
        estimator.execute();
        if (estimator.report()) report = *estimator.report();
      } while (estimator.report());
    }
  }
  /// What the report adds to the filter's covariance.
  double added() const {
    return (report.pose.covariance - estimator.backend().pose().covariance).trace();
  }

  SimulatedWorld world{1};
  Estimator estimator;
  StepReport report;
};

TEST_F(EstimatorDeadReckoning, AddsToTheCovarianceWhileNoLandmarkCorrectsThePose) {
  drive(100, true);
  EXPECT_EQ(added(), 0.0);
  drive(150, false);
  EXPECT_GT(added(), 0.1 * estimator.backend().pose().covariance.trace());
  EXPECT_EQ(report.trust, Trust::kConfident);
  drive(50, true);
  EXPECT_EQ(added(), 0.0);
}

}  // namespace
}  // namespace slam
