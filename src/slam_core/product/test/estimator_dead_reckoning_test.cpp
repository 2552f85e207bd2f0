// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::SimulatedWorld;

class EstimatorDeadReckoning : public testing::Test {
 protected:
  void use(const std::string& backend) {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create(backend));
    estimator.configure(settings);
  }
  void drive(int steps, bool sees_landmarks) {
    for (int i = 0; i < steps; ++i) {
      auto step = world.next();
      if (!sees_landmarks) step.observations.observations.clear();
      estimator.set(step.motion);
      estimator.set(step.observations);
      stepThrough();
    }
  }
  void stepThrough() {
    do {
      estimator.execute();
      if (estimator.report()) report = *estimator.report();
    } while (estimator.report());
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
  use("ekf");
  drive(100, true);
  EXPECT_EQ(added(), 0.0);
  drive(150, false);
  EXPECT_GT(added(), 0.1 * estimator.backend().pose().covariance.trace());
  EXPECT_EQ(report.trust, Trust::kConfident);
  drive(50, true);
  EXPECT_EQ(added(), 0.0);
}

TEST_F(EstimatorDeadReckoning, AnImageOfABlankWallIsNoCorrection) {
  use("mono_graph");
  test::RoundOfPictures round(1);
  const auto look = [&](int steps, bool is_blank) {
    for (int i = 0; i < steps; ++i) {
      const auto motion = round.drive();
      auto view = round.room().view(motion.end, round.place());
      if (is_blank) view.image.gray.setTo(100);
      estimator.set(motion);
      estimator.set(view);
      stepThrough();
    }
  };
  look(60, false);
  EXPECT_EQ(added(), 0.0);
  look(60, true);
  EXPECT_GT(added(), 0.1 * estimator.backend().pose().covariance.trace());
}

}  // namespace
}  // namespace slam
