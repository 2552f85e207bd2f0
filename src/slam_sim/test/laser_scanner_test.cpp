// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/laser_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slam::sim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A room of 4 m x 3 m with a low and a high box; the laser is 0.3 m high.
class LaserInARoom : public testing::Test {
 protected:
  LaserInARoom() {
    const std::vector<Eigen::Vector2d> corners = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    for (std::size_t i = 0; i < 4; ++i) world_.walls.push_back({corners[i], corners[(i + 1) % 4]});
    world_.furniture.push_back({{3.0, 1.0}, 0.0, {0.4, 0.4, 0.2}});
    world_.furniture.push_back({{1.0, 2.5}, M_PI / 4.0, {0.4, 0.4, 1.0}});
    laser_.position.z() = 0.3;
    laser_.beams = 5;
    laser_.field_of_view = M_PI;
    laser_.relative_noise = 0.0;
  }

  LaserReadings readings(const Pose2& pose, std::uint64_t seed = 1) const {
    const FloorPlan plan(world_);
    RandomStream random(seed, 0);
    return LaserScanner(plan, laser_).scan(pose, random);
  }
  std::vector<float> scan(const Pose2& pose, std::uint64_t seed = 1) const {
    return readings(pose, seed).ranges;
  }

  World world_;
  LaserModel laser_;
};

TEST_F(LaserInARoom, MeasuresWallsFromTheRightToTheLeft) {
  const auto ranges = scan(Pose2(1.0, 1.0, 0.0));
  ASSERT_EQ(ranges.size(), 5u);
  EXPECT_NEAR(ranges[0], 1.0, 1e-6);                         // right
  EXPECT_NEAR(ranges[1], std::sqrt(2.0), 1e-6);              // right ahead
  EXPECT_NEAR(ranges[2], 3.0, 1e-6);                         // over the low box
  EXPECT_NEAR(ranges[3], 2.0 * std::sqrt(2.0), 1e-6);        // left ahead
  EXPECT_NEAR(ranges[4], 1.5 - 0.2 * std::sqrt(2.0), 1e-6);  // the corner of the high box
}

TEST_F(LaserInARoom, SeesFromWhereItIsMounted) {
  laser_.position.head<2>() = Eigen::Vector2d(0.2, 0.1);
  laser_.yaw = M_PI / 2.0;
  const auto ranges = scan(Pose2(1.0, 1.0, 0.0));
  EXPECT_NEAR(ranges[0], 4.0 - 1.2, 1e-6);
  EXPECT_NEAR(ranges[4], 1.2, 1e-6);
}

TEST_F(LaserInARoom, TellsTooFarAndTooNearByInfinities) {
  laser_.max_range = 2.9;
  laser_.min_range = 1.2;
  const auto ranges = scan(Pose2(1.0, 1.0, 0.0));
  EXPECT_EQ(ranges[0], -kInfinity);
  EXPECT_EQ(ranges[2], kInfinity);
}

TEST_F(LaserInARoom, NothingAroundIsNoReturn) {
  world_.walls.clear();
  world_.furniture.clear();
  for (const float range : scan(Pose2(1.0, 1.0, 0.0))) EXPECT_EQ(range, kInfinity);
}

TEST_F(LaserInARoom, AReflectorIsBrighterThanAWallAndEitherFadesWithTheDistance) {
  EXPECT_TRUE(readings(Pose2(1.0, 1.0, 0.0)).intensities.empty()) << "there is none";
  world_.walls[1].is_reflector = true;  // ahead
  const auto from_far = readings(Pose2(1.0, 1.0, 0.0)).intensities;
  ASSERT_EQ(from_far.size(), 5u);
  EXPECT_NEAR(from_far[0], 800.0, 200.0) << "a light wall 1 m to the right";
  EXPECT_NEAR(from_far[2], 30000.0 / 9.0, 800.0);
  EXPECT_NEAR(readings(Pose2(2.5, 1.0, 0.0)).intensities[2], 30000.0 / 2.25, 3200.0);
}

TEST_F(LaserInARoom, NoiseIsProportionalToTheRange) {
  laser_.relative_noise = 0.01;
  double sum = 0.0, squares = 0.0;
  constexpr int kScans = 20000;
  for (int i = 0; i < kScans; ++i) {
    const double error = scan(Pose2(1.0, 1.0, 0.0), static_cast<std::uint64_t>(i))[2] - 3.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kScans, 0.0, 1e-3);
  EXPECT_NEAR(std::sqrt(squares / kScans), 0.03, 1e-3);
}

}  // namespace
}  // namespace slam::sim
