// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/map_repeats.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::relocalisation {
namespace {

LandmarkMap scattered(int count, std::uint64_t seed, double edge) {
  RandomStream random(seed, 0);
  LandmarkMap map;
  for (int i = 0; i < count; ++i)
    map.push_back({static_cast<LandmarkId>(i),
                   {edge * random.uniform(), edge * random.uniform()},
                   1e-6 * Eigen::Matrix2d::Identity()});
  return map;
}

std::vector<Pose2> repeatsIn(const LandmarkMap& map) {
  return repeatsOf(map, association::ConstellationSearch(map, 0.05), 2.0 * std::log(1000.0));
}

bool has(const std::vector<Pose2>& motions, const Pose2& motion) {
  return std::any_of(motions.begin(), motions.end(), [&](const Pose2& other) {
    return (other.vector() - motion.vector()).norm() < 0.05;
  });
}

TEST(MapRepeats, AreNoneInAWood) { EXPECT_TRUE(repeatsIn(scattered(120, 2, 15.0)).empty()); }

TEST(MapRepeats, AreNoneInAMapOfALandmarkOrNone) {
  EXPECT_TRUE(repeatsIn({}).empty());
  EXPECT_TRUE(repeatsIn(scattered(1, 2, 1.0)).empty());
}

TEST(MapRepeats, LeadFromOneTileToTheOther) {
  auto map = scattered(60, 3, 4.0);
  for (auto tile : scattered(20, 4, 1.5)) {
    map.push_back({100 + tile.id, tile.position + Eigen::Vector2d(0.0, -3.0), tile.covariance});
    map.push_back({200 + tile.id, tile.position + Eigen::Vector2d(5.0, -3.0), tile.covariance});
  }
  const auto repeats = repeatsIn(map);
  EXPECT_TRUE(has(repeats, Pose2(5.0, 0.0, 0.0)));
  EXPECT_TRUE(has(repeats, Pose2(-5.0, 0.0, 0.0)));
  EXPECT_EQ(repeats.size(), 2U);
}

TEST(MapRepeats, MayTurn) {
  const Pose2 turned(12.0, 1.0, 2.0);
  auto map = scattered(20, 4, 2.0);
  for (const auto& landmark : scattered(20, 4, 2.0))
    map.push_back({100 + landmark.id, turned.transform(landmark.position), landmark.covariance});
  EXPECT_TRUE(has(repeatsIn(map), turned));
}

}  // namespace
}  // namespace slam::relocalisation
