// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/constellation_search.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/relocalisation/test/some_landmarks.hpp"

namespace slam::association {
namespace {

using relocalisation::test::hall;
using relocalisation::test::nameless;
using relocalisation::test::seenFrom;

constexpr double kOutliers = 0.05;

Pose2 somewhere(RandomStream& random, double edge) {
  return {edge * random.uniform(), edge * random.uniform(), 2.0 * M_PI * random.uniform()};
}

double neesOf(const PoseEstimate& estimate, const Pose2& truth) {
  Eigen::Vector3d e = estimate.pose.vector() - truth.vector();
  e.z() = wrapAngle(e.z());
  return e.dot(estimate.covariance.llt().solve(e));
}

TEST(ConstellationSearch, FindsTheRobotByLandmarksWithIdsWhereverItIs) {
  RandomStream random(1, 1);
  double nees = 0.0;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto map = hall(seed, 12, 10.0);
    const auto truth = somewhere(random, 10.0);
    const auto seen = seenFrom(truth, map, 4.0, random);
    if (seen.size() < 3) continue;
    const auto places = ConstellationSearch(map, kOutliers).placesOf(seen);
    ASSERT_FALSE(places.empty()) << "seed " << seed;
    EXPECT_LT((places[0].robot.pose.position() - truth.position()).norm(), 0.3) << "seed " << seed;
    nees += neesOf(places[0].robot, truth);
    ++found;
  }
  ASSERT_GT(found, 30);
  EXPECT_LT(nees / found, 3.5);  // 3 where the covariance is right; map and sensor have slack
  EXPECT_GT(nees / found, 1.0);
}

TEST(ConstellationSearch, FindsTheRobotByLandmarksWithoutIds) {
  RandomStream random(2, 1);
  int found = 0, tried = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto map = hall(seed, 40, 20.0);
    const auto truth = somewhere(random, 20.0);
    const auto seen = nameless(seenFrom(truth, map, 6.0, random));
    if (seen.size() < 7) continue;
    ++tried;
    const auto places = ConstellationSearch(map, kOutliers).placesOf(seen);
    ASSERT_FALSE(places.empty());
    found += (places[0].robot.pose.position() - truth.position()).norm() < 0.3;
  }
  ASSERT_GT(tried, 10);
  EXPECT_EQ(found, tried);
}

TEST(ConstellationSearch, FindsTheRobotAmongSightingsOfWhichMostAreFalse) {
  RandomStream random(3, 1);
  const auto map = hall(3, 20, 10.0);
  const Pose2 truth(5.0, 5.0, 1.0);
  auto seen = seenFrom(truth, map, 4.0, random);
  ASSERT_GE(seen.size(), 4u);
  const auto right = seen.size();
  for (std::size_t i = 0; i < right + 2; ++i)
    seen.push_back({static_cast<LandmarkId>(1 + i),
                    {8.0 * random.uniform() - 4.0, 8.0 * random.uniform() - 4.0},
                    1e-3 * Eigen::Matrix2d::Identity()});
  const auto places = ConstellationSearch(map, kOutliers).placesOf(seen);
  ASSERT_FALSE(places.empty());
  EXPECT_LT((places[0].robot.pose.position() - truth.position()).norm(), 0.1);
}

TEST(ConstellationSearch, FindsTwoEquallyLikelyPlacesInAMapOfTwoIdenticalHalves) {
  RandomStream random(4, 1);
  auto map = hall(4, 10, 8.0);
  const auto half = map;
  for (const auto& landmark : half) {
    map.push_back(landmark);
    map.back().id += 100;
    map.back().position.x() += 20.0;
  }
  const auto seen = nameless(seenFrom({4.0, 4.0, 0.0}, map, 6.0, random));
  const auto places = ConstellationSearch(map, kOutliers).placesOf(seen);
  ASSERT_GE(places.size(), 2u);
  EXPECT_NEAR(places[0].log_odds, places[1].log_odds, 1e-6);
  EXPECT_NEAR(std::abs(places[0].robot.pose.x() - places[1].robot.pose.x()), 20.0, 1e-6);
}

/// One half of the map has an additional landmark, which the sensor would see there.
TEST(ConstellationSearch, PrefersThePlaceWhereNothingIsMissing) {
  RandomStream random(4, 1);
  const auto half = hall(4, 10, 8.0);
  auto map = half;
  for (auto landmark : half) {
    landmark.id += 100;
    landmark.position.x() += 20.0;
    map.push_back(landmark);
  }
  for (int i = 0; i < 6; ++i)
    map.push_back({200 + i, {23.0 + 0.4 * i, 4.5}, 1e-4 * Eigen::Matrix2d::Identity()});
  const Pose2 truth(4.0, 4.0, 0.0);
  const auto seen = nameless(seenFrom(truth, map, 6.0, random));
  association::SensorReach reach;
  LandmarkObservationArray all_round;
  for (int i = 0; i < 240; ++i) {
    LandmarkObservation z;
    z.range = 5.0;
    z.bearing = 2.0 * M_PI * i / 240 - M_PI;
    all_round.observations.push_back(z);
  }
  reach.see(all_round);
  const auto places = ConstellationSearch(map, kOutliers).placesOf(seen, reach);
  ASSERT_GE(places.size(), 2u);
  EXPECT_NEAR(places[0].robot.pose.x(), truth.x(), 0.2);
  EXPECT_GT(places[0].log_odds, places[1].log_odds + 2.0);
}

/// The halves of this hall lie alike, and the landmarks of one are thicker.
TEST(ConstellationSearch, TellsTwoHalvesApartByDescriptors) {
  RandomStream random(5, 1);
  auto map = hall(4, 8, 6.0);
  for (auto& landmark : map) landmark.descriptor = descriptorOf(0.1, 0.01);
  for (std::size_t i = 0; i < 8; ++i) {
    auto twin = map[i];
    twin.id += 100;
    twin.position.x() += 20.0;
    twin.descriptor = descriptorOf(0.3, 0.01);
    map.push_back(twin);
  }
  const Pose2 truth(23.0, 3.0, 0.4);
  auto seen = nameless(seenFrom(truth, map, 4.0, random));
  ASSERT_GE(seen.size(), 3u);
  const auto alike = ConstellationSearch(map, kOutliers).placesOf(seen);
  ASSERT_GE(alike.size(), 2u);
  EXPECT_LT(alike[0].log_odds - alike[1].log_odds, 3.0);
  for (auto& landmark : seen) landmark.descriptor = descriptorOf(0.3, 0.02);
  const auto places = ConstellationSearch(map, kOutliers).placesOf(seen);
  ASSERT_FALSE(places.empty());
  EXPECT_LT((places[0].robot.pose.position() - truth.position()).norm(), 0.3);
  if (places.size() > 1) {
    EXPECT_GT(places[0].log_odds - places[1].log_odds, 3.0);
  }
}

TEST(ConstellationSearch, FindsNothingWhereThereIsTooLittle) {
  RandomStream random(5, 1);
  const auto map = hall(5, 12, 10.0);
  auto seen = seenFrom({5.0, 5.0, 0.0}, map, 5.0, random);
  EXPECT_TRUE(ConstellationSearch({}, kOutliers).placesOf(seen).empty());
  EXPECT_TRUE(ConstellationSearch(map, kOutliers).placesOf({}).empty());
  seen.resize(1);
  EXPECT_TRUE(ConstellationSearch(map, kOutliers).placesOf(seen).empty());
  for (auto& landmark : seen) landmark.id = 1000;
  EXPECT_TRUE(ConstellationSearch(map, kOutliers).placesOf(seen).empty());
}

TEST(ConstellationSearch, IsUnlikelyWhereTheSightingsHaveNothingToDoWithTheMap) {
  RandomStream random(6, 1);
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto map = hall(seed, 20, 10.0);
    const auto elsewhere =
        nameless(seenFrom({5.0, 5.0, 0.0}, hall(seed + 1000, 20, 10.0), 3.0, random));
    for (const auto& place : ConstellationSearch(map, kOutliers).placesOf(elsewhere))
      EXPECT_LT(place.log_odds, std::log(100.0)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace slam::association
