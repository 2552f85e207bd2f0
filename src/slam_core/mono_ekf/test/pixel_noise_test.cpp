// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/pixel_noise.hpp"

#include <gtest/gtest.h>

#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

using test::PointCloudDrive;
using test::PointCloudFilter;

void drive(PointCloudFilter& filter, double pixel_sigma, int laps = 1) {
  filter.drive().setPixelSigma(pixel_sigma);
  for (int i = 0; i < laps * PointCloudDrive::kLap; ++i) filter.step();
}

TEST(PixelNoise, IsFoundFromTheInnovations) {
  for (const double sigma : {0.5, 0.7, 1.4, 2.8})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      PointCloudFilter filter(seed);
      drive(filter, sigma);
      EXPECT_NEAR(filter.pixelSigma(), sigma, 0.1 * sigma) << "seed " << seed;
    }
}

TEST(PixelNoise, IsNeverBelowItsLeast) {
  PointCloudFilter filter(1);
  drive(filter, 0.1);
  EXPECT_EQ(filter.pixelSigma(), PointCloudFilter::kLeastSigma);
}

TEST(PixelNoise, FollowsACameraThatBeginsToShakeAndStopsToShake) {
  PointCloudFilter filter(2);
  for (const double sigma : {0.5, 2.0, 0.5}) {
    drive(filter, sigma, 2);
    EXPECT_NEAR(filter.pixelSigma(), sigma, 0.15 * sigma);
  }
}

}  // namespace
}  // namespace slam::mono_ekf
