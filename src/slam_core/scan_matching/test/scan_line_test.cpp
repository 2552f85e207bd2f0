// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::scan_matching {
namespace {

using Ends = std::vector<Eigen::Vector2d>;

constexpr double kReachOfMap = 2.0;   // [cells]
constexpr double kSmallNoise = 0.01;  // [cells^2]
const Ends kWall = {{0, 7}, {5, 7}, {11, 7}, {18, 7}, {27, 7}};

TEST(ScanLine, RunsAlongAWallOfWhichEndsLieFarApart) {
  for (std::size_t i = 0; i < kWall.size(); ++i) {
    const auto line = scanLineAt(kWall, i, kReachOfMap, kSmallNoise);
    ASSERT_TRUE(line) << "also at the edge of what is seen, end " << i;
    EXPECT_NEAR(std::abs(line->direction.x()), 1.0, 1e-9);
    EXPECT_LT(line->tilt, 0.01);
  }
}

TEST(ScanLine, IsKnownTheLessTheNoisierTheEnds) {
  const auto sure = scanLineAt(kWall, 2, kReachOfMap, kSmallNoise);
  const auto vague = scanLineAt(kWall, 2, kReachOfMap, 4 * kSmallNoise);
  ASSERT_TRUE(sure && vague);
  EXPECT_NEAR(vague->tilt, 4 * sure->tilt, 1e-9);
  EXPECT_NEAR(sure->tilt, kSmallNoise / (8.0 * 8.0), 1e-9) << "half the longest chord, 11 to 27";
}

TEST(ScanLine, GoesByWhatLiesBeyondTheNoise) {
  // Noise puts the ends of a wall that is met at a small angle into another order.
  const Ends scrambled = {{0, 7}, {6, 7}, {5, 7}, {7, 7}, {6, 7}, {12, 7}};
  const auto line = scanLineAt(scrambled, 3, kReachOfMap, 0.25);
  ASSERT_TRUE(line);
  EXPECT_NEAR(std::abs(line->direction.x()), 1.0, 1e-9);
}

TEST(ScanLine, IsNoneAtAPoleInFrontOfAWall) {
  const Ends with_pole = {{0, 20}, {5, 20}, {10, 8}, {10.5, 8}, {15, 20}, {20, 20}};
  EXPECT_FALSE(scanLineAt(with_pole, 2, kReachOfMap, kSmallNoise));
  EXPECT_FALSE(scanLineAt(with_pole, 3, kReachOfMap, kSmallNoise));
}

TEST(ScanLine, IsNoneAtACornerThatOnlyOneEndShows) {
  const Ends corner = {{0, 7}, {8, 0}, {16, 7}};
  EXPECT_FALSE(scanLineAt(corner, 1, kReachOfMap, kSmallNoise));
}

TEST(ScanLine, IsNoneOfFewerThanThreeEnds) {
  EXPECT_FALSE(scanLineAt({{0, 7}}, 0, kReachOfMap, kSmallNoise));
  EXPECT_FALSE(scanLineAt({{0, 7}, {5, 7}}, 0, kReachOfMap, kSmallNoise));
  EXPECT_FALSE(scanLineAt({{0, 7}, {1, 7}, {2, 7}}, 1, kReachOfMap, kSmallNoise))
      << "all within what the map has been looked at";
}

}  // namespace
}  // namespace slam::scan_matching
