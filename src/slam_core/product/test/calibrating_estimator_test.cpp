// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/miscalibrated_robot.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

/// Each back-end that calibrates, and a robot whose wheels are off by far more than their prior.
class CalibratingEstimator : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings({}, {},
                      {"calibration.estimate=[wheel_scale]", "calibration.sigma_wheel_scale=0.02",
                       "consistency.adapt=false"});
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
    CalibrationVector off = CalibrationVector::Zero();
    off(kWheelScale) = 0.12;
    test::MiscalibratedRobot robot(1, off);
    for (int i = 0; i < 100; ++i) drive(robot.next(i > 0));
  }
  void drive(const test::SimulatedStep& step) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    for (auto status = estimator.execute(); estimator.report(); status = estimator.execute()) {
      if (!status.isOk()) told = status.message;
      ASSERT_TRUE(estimator.report()->pose.pose.isFinite());
    }
  }

  Estimator estimator;
  std::string told;
};

INSTANTIATE_TEST_SUITE_P(Backends, CalibratingEstimator, testing::Values("ekf", "graph"),
                         [](const auto& backend) { return backend.param; });

TEST_P(CalibratingEstimator, TellsOfACalibrationThatRunsAway) {
  EXPECT_NE(told.find("wheel_scale is"), std::string::npos) << told;
  EXPECT_NE(told.find("check the robot file"), std::string::npos) << told;
}

TEST_P(CalibratingEstimator, ShowsTheParametersAmongItsFigures) {
  const auto figures = estimator.figures();
  for (const std::string name : {"wheel_scale", "wheel_scale_sigma"})
    EXPECT_TRUE(std::any_of(figures.begin(), figures.end(), [&](const auto& figure) {
      return figure.first == name;
    })) << name;
}

}  // namespace
}  // namespace slam
