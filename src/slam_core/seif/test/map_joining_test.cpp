// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/map_joining.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace slam::seif {
namespace {

const std::vector<Eigen::Vector2d> kPlaces = {{0, 0}, {4, 0}, {4, 3}, {0, 5}, {-3, 2}};

/// Some of the places as they are seen from a base, each as certain as the other.
MappedPart partOf(const Pose2& base, const std::vector<std::size_t>& landmarks, double sigma) {
  MappedPart part;
  for (const auto landmark : landmarks) {
    part.landmarks.push_back(landmark);
    part.map.points.push_back(base.inverse().transform(kPlaces[landmark]));
  }
  const auto size = 2 * static_cast<Eigen::Index>(landmarks.size());
  part.map.covariance = sigma * sigma * Eigen::MatrixXd::Identity(size, size);
  return part;
}

TEST(MapJoining, PutsTheSecondMapWhereTheSharedLandmarksLie) {
  const Pose2 first_base(1, 1, 0.3), second_base(-2, 4, 2.0);
  const auto both =
      joined(partOf(first_base, {0, 1, 2}, 0.01), partOf(second_base, {1, 2, 3, 4}, 0.01), {}, 1.0);
  ASSERT_TRUE(both);
  ASSERT_EQ(both->landmarks.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto expected = first_base.inverse().transform(kPlaces[both->landmarks[i]]);
    EXPECT_LT((both->map.points[i] - expected).norm(), 1e-6);
  }
}

/// Two maps of the same landmarks in the same frame are two measurements of each, but for the three
/// directions in which nobody knows how they lie to one another.
TEST(MapJoining, AddsTheInformationOfBoth) {
  const auto part = partOf(Pose2(), {0, 1, 2, 3, 4}, 0.02);
  const auto both = joined(part, part, {}, 1.0);
  ASSERT_TRUE(both);
  const double before = part.map.covariance.trace(), after = both->map.covariance.trace();
  const double variance = 0.02 * 0.02;
  EXPECT_NEAR(after, before - 0.5 * variance * (10 - 3), 1e-6);
}

TEST(MapJoining, LeavesOneSharedLandmarkAlone) {
  EXPECT_FALSE(joined(partOf(Pose2(), {0, 1}, 0.01), partOf(Pose2(), {1, 2}, 0.01), {}, 1.0));
}

TEST(MapJoining, LeavesMapsAloneWhoseHeadingsAreUncertain) {
  const auto first = partOf(Pose2(), {0, 1, 2}, 0.05), second = partOf(Pose2(), {1, 2, 3}, 0.05);
  EXPECT_TRUE(joined(first, second, {}, 0.2));
  EXPECT_FALSE(joined(first, second, {}, 0.01));
}

TEST(MapJoining, MarginalisesAPoseBetweenBoth) {
  auto first = partOf(Pose2(), {0, 1}, 0.01), second = partOf(Pose2(1, 0, 0), {2, 3}, 0.01);
  for (auto* part : {&first, &second}) {
    const auto size = part->map.covariance.rows();
    Eigen::MatrixXd P = 1e-4 * Eigen::MatrixXd::Identity(size + 3, size + 3);
    P.bottomRightCorner(size, size) = part->map.covariance;
    part->map.covariance = P;
    part->poses = {7};
  }
  first.map.poses = {Pose2(1, 1, 0.5)};
  second.map.poses = {Pose2(0, 1, 0.5)};
  const auto both = joined(first, second, {7}, 1.0);
  ASSERT_TRUE(both);
  EXPECT_TRUE(both->poses.empty());
  EXPECT_EQ(both->landmarks.size(), 4u);
  EXPECT_LT((both->map.points[3] - kPlaces[3]).norm(), 1e-6);
}

}  // namespace
}  // namespace slam::seif
