// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/motion_evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace slam::graph_slam {
namespace {

Eigen::Matrix3d covarianceOf(double x, double y, double theta) {
  Eigen::Matrix3d P = Eigen::Vector3d(x * x, y * y, theta * theta).asDiagonal();
  P(0, 1) = P(1, 0) = 0.3 * x * y;
  return P;
}

TEST(MotionEvidence, IsWhatAnEstimateAddsToTheOneItHasUsed) {
  const auto odometry = covarianceOf(0.02, 0.01, 0.05), scan = covarianceOf(0.01, 0.03, 0.002);
  const Eigen::Matrix3d both = (odometry.inverse() + scan.inverse()).inverse();
  const auto left = informationBeyond(both, odometry);
  EXPECT_LT((left - scan.inverse()).norm(), 1e-6 * left.norm());
}

TEST(MotionEvidence, IsNothingWhereOdometryWasCopied) {
  const auto odometry = covarianceOf(0.02, 0.01, 0.05);
  for (const double worse : {1.0, 4.0}) {
    const auto left = informationBeyond(worse * odometry, odometry);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(left);
    EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
    EXPECT_LT(solver.eigenvalues().maxCoeff(), 1e-3);
  }
}

TEST(MotionEvidence, IsKeptInTheDirectionThatAScanDeterminesAlone) {
  Eigen::Matrix3d corridor = covarianceOf(0.02, 0.01, 0.05), odometry = corridor;
  corridor(0, 1) = corridor(1, 0) = odometry(0, 1) = odometry(1, 0) = 0.0;
  corridor(1, 1) *= 0.01;
  const auto left = informationBeyond(corridor, odometry);
  EXPECT_LT(left(0, 0), 1e-3);
  EXPECT_NEAR(left(1, 1), 99.0 / odometry(1, 1), 1e-6 / odometry(1, 1));
}

TEST(MotionEvidence, ContradictsWhereTheDifferenceIsBeyondBothNoises) {
  const PoseEstimate scan{Pose2(0.10, 0.0, 0.30), covarianceOf(0.002, 0.002, 0.002)};
  const auto odometry = [](double x, double theta) {
    return PoseEstimate{Pose2(x, 0.0, theta), covarianceOf(0.002, 0.002, 0.05)};
  };
  EXPECT_FALSE(contradict(odometry(0.10, 0.30), scan));
  EXPECT_FALSE(contradict(odometry(0.105, 0.30), scan));
  EXPECT_FALSE(contradict(odometry(0.10, 0.40), scan));
  EXPECT_TRUE(contradict(odometry(0.12, 0.30), scan));
  EXPECT_TRUE(contradict(odometry(0.10, 0.60), scan));
  EXPECT_TRUE(contradict(scan, odometry(0.10, 0.60)));
}

}  // namespace
}  // namespace slam::graph_slam
