// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/geometry/principal_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam {
namespace {

TEST(PrincipalAxesTest, AreThoseOfATurnedEllipse) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  Eigen::Matrix2d turn, covariance;
  turn << c, -s, s, c;
  covariance = turn * Eigen::Vector2d(9.0, 0.25).asDiagonal() * turn.transpose();
  const auto axes = principalAxes(covariance);
  EXPECT_NEAR(axes.values(0), 0.25, 1e-12);
  EXPECT_NEAR(axes.values(1), 9.0, 1e-12);
  EXPECT_NEAR(std::abs(axes.directions.col(1).dot(turn.col(0))), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(largestVariance(covariance), axes.values(1));
}

TEST(PrincipalAxesTest, MakeUpTheMatrix) {
  Eigen::Matrix3d A;
  A << 4, 1, -2, 1, 3, 0.5, -2, 0.5, 5;
  const auto axes = principalAxes(A);
  const Eigen::Matrix3d again =
      axes.directions * axes.values.asDiagonal() * axes.directions.transpose();
  EXPECT_LT((again - A).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(axes.values(0), axes.values(1));
  EXPECT_LT(axes.values(1), axes.values(2));
  const auto of_any_size = principalAxes(Eigen::MatrixXd(A));
  EXPECT_LT((of_any_size.values - axes.values).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PrincipalAxesTest, HaveNoValuesWhereTheMatrixIsNotFinite) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(1, 0) = A(0, 1) = std::nan("");
  EXPECT_FALSE(principalAxes(A).values.allFinite());
}

}  // namespace
}  // namespace slam
