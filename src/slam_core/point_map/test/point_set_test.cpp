// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/point_set.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/random.hpp"

namespace slam::point_map {
namespace {

/// The nearest by looking at every point.
std::optional<std::uint32_t> bruteForce(const PointSet& set, const Eigen::Vector2d& at,
                                        double radius) {
  std::optional<std::uint32_t> best;
  double nearest = radius * radius;
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    const double distance = (set.points()[i].position - at).squaredNorm();
    if (distance > nearest || (best && distance == nearest)) continue;
    best = i;
    nearest = distance;
  }
  return best;
}

TEST(PointSet, FindsTheNearestAsASearchOfAllPointsDoes) {
  RandomStream random(1, 0);
  const auto drawn = [&] {
    return Eigen::Vector2d(8 * random.uniform() - 4, 6 * random.uniform());
  };
  PointSet set(0.2);
  for (int i = 0; i < 3000; ++i) {
    set.append(drawn());
    if (i % 3 == 0) set.fuse(static_cast<std::uint32_t>(i / 2), drawn());  // which moves it far
  }
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto at = drawn();
    const double radius = 0.5 * random.uniform();
    const auto expected = bruteForce(set, at, radius);
    found += expected ? 1 : 0;
    ASSERT_EQ(set.nearest(at, radius), expected) << "query " << i;
  }
  EXPECT_GT(found, 1000);
}

TEST(PointSet, APointIsTheMeanOfAllThatWasFusedIntoIt) {
  PointSet set;
  set.append({1, 0});
  set.fuse(0, {2, 0});
  set.fuse(0, {3, 3});
  EXPECT_LT((set.points()[0].position - Eigen::Vector2d(2, 1)).norm(), 1e-12);
  EXPECT_EQ(set.points()[0].count, 3u);
  EXPECT_EQ(set.nearest({2, 1}, 0.01), 0u) << "it is found where it has moved to";
  EXPECT_FALSE(set.nearest({1, 0}, 0.5));
}

TEST(PointSet, JoinsTwoPointsToTheMeanOfBoth) {
  PointSet set;
  for (int i = 0; i < 4; ++i) set.append({2.0 * i, 0});
  set.fuse(3, {6, 0});  // counts twice
  EXPECT_EQ(set.join(3, 0), 0u) << "the last point has moved to the other's place";
  ASSERT_EQ(set.size(), 3u);
  EXPECT_NEAR(set.points()[0].position.x(), 4.0, 1e-12);
  EXPECT_EQ(set.points()[0].count, 3u);
  EXPECT_EQ(set.join(0, 1), 0u);
  EXPECT_EQ(set.nearest({4, 0}, 0.1), 1u) << "the one that was the last but one";
  EXPECT_EQ(set.nearest({3.5, 0}, 0.1), 0u);
  EXPECT_FALSE(set.nearest({6, 0}, 0.5));
  EXPECT_FALSE(set.nearest({2, 0}, 0.5));
}

TEST(PointSet, VisitsAllThatAreNear) {
  PointSet set(0.2);
  for (int i = 0; i < 100; ++i) set.append({0.1 * i, 0.0});
  int visited = 0;
  set.visitNear({5.0, 0.0}, 0.55, [&](std::uint32_t) { ++visited; });
  EXPECT_EQ(visited, 11);
}

TEST(PointSet, OfTwoAtTheSameDistanceTheFirstCounts) {
  PointSet set;
  set.append({1, 1});
  set.append({1, -1});
  EXPECT_EQ(set.nearest({1, 0}, 2), 0u);
  EXPECT_FALSE(set.nearest({1, 0}, 0.9));
}

TEST(PointSet, IsEmptyAfterClear) {
  PointSet set;
  for (int i = 0; i < 5000; ++i) set.append({0.01 * i, 0});
  set.clear();
  EXPECT_EQ(set.size(), 0u);
  EXPECT_FALSE(set.nearest({1, 0}, 1));
}

}  // namespace
}  // namespace slam::point_map
