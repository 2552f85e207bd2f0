// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_map.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

const Eigen::Vector3d kLargest(10.0, 20.0, 3.0);

PoseEstimate estimateOf(const Eigen::Vector3d& sigmas) {
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Identity();
  correlation(0, 1) = correlation(1, 0) = 0.5;
  correlation(1, 2) = correlation(2, 1) = -0.25;
  return {Pose2(1, 2, 0.5), sigmas.asDiagonal() * correlation * sigmas.asDiagonal()};
}

TEST(BoundedEstimate, StaysAsItIsWithinTheBounds) {
  const auto estimate = estimateOf({1.0, 2.0, 0.5});
  EXPECT_EQ(bounded(estimate, kLargest).covariance, estimate.covariance);
  EXPECT_EQ(bounded(estimate, kLargest).pose.vector(), estimate.pose.vector());
}

TEST(BoundedEstimate, HasTheLargestSigmasAndTheSameCorrelations) {
  const auto estimate = bounded(estimateOf({1e6, 2.0, 1e3}), kLargest);
  EXPECT_TRUE(estimate.covariance.isApprox(estimateOf({10.0, 2.0, 3.0}).covariance, 1e-12))
      << estimate.covariance;
}

TEST(MapWithoutLines, HasThePointsWithTheirCovariances) {
  MapState map;
  map.landmarks.resize(3);
  for (LandmarkId id = 0; id < 3; ++id) map.landmarks[static_cast<std::size_t>(id)].id = id;
  map.landmarks[1].kind = LandmarkKind::kLine;
  map.joint_covariance.resize(9, 9);
  for (Eigen::Index row = 0; row < 9; ++row)
    for (Eigen::Index column = 0; column < 9; ++column)
      map.joint_covariance(row, column) = static_cast<double>(10 * row + column);
  const auto points = withoutLines(map);
  ASSERT_EQ(points.landmarks.size(), 2u);
  EXPECT_EQ(points.landmarks[1].id, 2);
  ASSERT_EQ(points.joint_covariance.rows(), 7);
  EXPECT_EQ(points.joint_covariance(4, 6), 48.0) << "of landmark 0 with landmark 2";
  map.joint_covariance.resize(0, 0);
  EXPECT_EQ(withoutLines(map).landmarks.size(), 2u);
  EXPECT_EQ(withoutLines(map).joint_covariance.size(), 0);
}

}  // namespace
}  // namespace slam
