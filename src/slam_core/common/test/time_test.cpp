// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/time.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

TEST(Time, KeepsEveryNanosecondOfAnEpochStamp) {
  const auto stamp = stampFromNanoseconds(1288971842053000001);
  EXPECT_EQ(nanoseconds(stamp), 1288971842053000001);
  EXPECT_EQ(nanoseconds(stamp + std::chrono::milliseconds(20)), 1288971842073000001);
}

TEST(Time, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(durationFromSeconds(0.1).count(), 100000000);
  EXPECT_EQ(durationFromSeconds(0.29).count(), 290000000);  // 0.29e9 is 289999999.99...
  EXPECT_EQ(durationFromSeconds(-0.29).count(), -290000000);
  EXPECT_EQ(durationFromSeconds(0.0).count(), 0);
}

TEST(Time, GivesSecondsOfADuration) {
  EXPECT_DOUBLE_EQ(seconds(std::chrono::nanoseconds(1500000000)), 1.5);
  EXPECT_DOUBLE_EQ(seconds(std::chrono::milliseconds(-20)), -0.02);
}

}  // namespace
}  // namespace slam
