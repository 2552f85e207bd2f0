// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/invariant_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

TEST(InvariantStep, IsOneOfThePositionInTheFirstOrder) {
  const Eigen::Vector2d position(3.0, -2.0), step(1e-4, 2e-4);
  EXPECT_LT((stepped(position, step, 1e-4) - position - step).norm(), 1e-7);
}

TEST(InvariantStep, TurnsAMapAboutAPlace) {
  const Eigen::Vector2d place(1.0, 2.0), position(4.0, 6.0);
  const double alpha = 0.5 * M_PI;
  // the error of a map that began at `place` with a wrong heading
  const Eigen::Vector2d step = alpha * turnedLeft(position - place);
  EXPECT_LT((stepped(position, step, alpha) - Eigen::Vector2d(-3.0, 5.0)).norm(), 1e-12);
  EXPECT_LT((stepped(place, {0.0, 0.0}, alpha) - place).norm(), 1e-12);
}

TEST(InvariantStep, LeadsFromOnePositionToAnother) {
  const Eigen::Vector2d from(3.0, -2.0), step(0.7, -0.4);
  for (const double alpha : {0.0, 1e-9, -0.8, 2.0})
    EXPECT_LT((stepBetween(from, stepped(from, step, alpha), alpha) - step).norm(), 1e-9) << alpha;
}

/// No image shows where the map as a whole points to.
TEST(MonoState, GetsNoSurerOfItsFirstHeading) {
  constexpr double kSigma = 0.1;
  test::PointCloudFilter filter(1);
  filter.state().place({Pose2(), Eigen::Vector3d(1e-6, 1e-6, kSigma * kSigma).asDiagonal()});
  for (int i = 0; i < test::PointCloudDrive::kLap / 2; ++i) {
    filter.step();
    ASSERT_GT(std::sqrt(filter.state().robot().covariance(2, 2)), 0.999 * kSigma) << i;
  }
}

}  // namespace
}  // namespace slam::mono_ekf
