// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

/// It breaks with the sixth array of observations, for good.
class BrokenBackend final : public Backend {
 public:
  void describe(Ports& ports) override {
    ports.takes<Motion>("motion", "motion", this).carrier();
    ports.takes<LandmarkObservationArray>("observations", "landmarks", this);
  }
  void configure(Settings&) override {}
  void set(const Motion& motion) { motion_ = motion; }
  void set(const LandmarkObservationArray& array) { is_broken_ |= array.sequence == 5; }
  void set(const PoseEstimate&) override {}
  Status execute() override { return Status::ok(); }
  PoseEstimate pose() const override {
    const double x = is_broken_ ? std::nan("") : motion_.increment.x();
    return {Pose2(x, 0, 0), Eigen::Matrix3d::Identity()};
  }
  Counters counters() const override { return {}; }
  void reset() override { is_broken_ = false; }

 private:
  Motion motion_;
  bool is_broken_ = false;
};

TEST(EstimatorOfABrokenBackend, ReportsNoPoseThatIsNotFiniteAndSaysSo) {
  Estimator estimator;
  Settings settings;
  estimator.use(std::make_unique<BrokenBackend>());
  estimator.configure(settings);
  int steps = 0, errors = 0;
  const auto run = [&](std::uint64_t seed) {
    test::SimulatedWorld world(seed);
    for (int i = 0; i < 10; ++i) {
      const auto step = world.next();
      estimator.set(step.motion);
      estimator.set(step.observations);
      const auto status = estimator.execute();
      steps += estimator.report().has_value();
      errors += status.level == Status::Level::kError;
      if (status.isOk()) continue;
      EXPECT_NE(status.message.find("not a finite number"), std::string::npos);
    }
  };
  run(1);
  EXPECT_EQ(steps, 5);
  EXPECT_EQ(errors, 5);
  EXPECT_EQ(estimator.counters()["not_finite_pose"], 5u);
  estimator.reset();
  steps = 0;
  run(1);
  EXPECT_EQ(steps, 5);
}

}  // namespace
}  // namespace slam
