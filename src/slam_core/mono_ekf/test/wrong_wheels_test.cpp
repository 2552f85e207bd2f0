// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

/// An odometry that measures each turn too small, within what it claims.
TEST(MonoState, EstimatesWhatTheWheelsMeasureWrongAndKeepsIt) {
  constexpr double kMeasured = 0.9;  // of a turn
  test::PointCloudFilter filter(3, kMeasured);
  for (int i = 0; i < test::PointCloudDrive::kLap; ++i) filter.step();
  EXPECT_LT(filter.nees(), 20.0);
  EXPECT_LT((filter.state().robot().pose.position() - filter.drive().truth().position()).norm(),
            0.05);
  const double before = filter.headingError();
  for (int i = 0; i < 25; ++i) filter.stepInTheDark();
  EXPECT_LT(std::abs(filter.headingError() - before), 0.3 * 0.1 * M_PI_2) << "of a quarter turn";
}

}  // namespace
}  // namespace slam::mono_ekf
