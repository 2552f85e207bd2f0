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

}  // namespace
}  // namespace slam
