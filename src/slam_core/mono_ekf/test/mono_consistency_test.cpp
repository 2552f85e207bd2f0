// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

using test::PointCloudDrive;
using test::PointCloudFilter;

TEST(MonoState, IsConsistentOverManyDrives) {
  constexpr int kDrives = 8;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 20; seed < 20 + kDrives; ++seed) {
    PointCloudFilter filter(seed);
    for (int i = 0; i < PointCloudDrive::kLap; ++i) {
      filter.step();
      if (i % 10 != 9) continue;
      sum += filter.nees();
      ++count;
    }
  }
  EXPECT_GT(sum / count, 1.0) << "3 is expected";
  EXPECT_LT(sum / count, 4.5);
}

}  // namespace
}  // namespace slam::mono_ekf
