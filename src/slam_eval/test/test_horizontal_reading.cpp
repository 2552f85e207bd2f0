// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "horizontal_reading.hpp"

namespace slam::eval {
namespace {

Eigen::Matrix3d diagonal(double range, double yaw, double pitch) {
  return Eigen::Vector3d(range * range, yaw * yaw, pitch * pitch).asDiagonal();
}

TEST(HorizontalReading, IsTheReadingItselfInAPlane) {
  const auto reading =
      toHorizontal(Eigen::Matrix3d::Identity(), {3.0, -0.4, 0.0}, diagonal(0.1, 0.02, 0.0));
  EXPECT_DOUBLE_EQ(reading.range, 3.0);
  EXPECT_DOUBLE_EQ(reading.bearing, -0.4);
  EXPECT_NEAR(reading.covariance(0, 0), 0.01, 1e-15);
  EXPECT_NEAR(reading.covariance(1, 1), 0.0004, 1e-15);
  EXPECT_NEAR(reading.covariance(0, 1), 0.0, 1e-15);
}

TEST(HorizontalReading, ShortensARangeThatLooksDown) {
  const auto reading =
      toHorizontal(Eigen::Matrix3d::Identity(), {2.0, 0.3, M_PI / 3.0}, diagonal(0.1, 0.02, 0.03));
  EXPECT_NEAR(reading.range, 1.0, 1e-12);
  EXPECT_NEAR(reading.bearing, 0.3, 1e-12);
  EXPECT_NEAR(reading.covariance(0, 0), 0.25 * 0.01 + 3.0 * 0.0009, 1e-12);
}

TEST(HorizontalReading, UndoesTheTiltOfTheSensor) {
  // Looking 0.5 rad down in a sensor that is tilted 0.5 rad up is looking level.
  const Eigen::Matrix3d up = Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto reading = toHorizontal(up, {4.0, 0.0, 0.5}, diagonal(0.1, 0.02, 0.03));
  EXPECT_NEAR(reading.range, 4.0, 1e-12);
  EXPECT_NEAR(reading.bearing, 0.0, 1e-12);
}

TEST(HorizontalReading, PropagatesTheCovarianceLikeNumericDerivatives) {
  const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Vector3d z(3.0, 0.7, -0.4);
  const Eigen::Matrix3d covariance = diagonal(0.1, 0.02, 0.03);
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 2, 3> J;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(i);
    const auto plus = toHorizontal(tilt, z + d, covariance);
    const auto minus = toHorizontal(tilt, z - d, covariance);
    J.col(i) << (plus.range - minus.range) / (2.0 * kStep),
        (plus.bearing - minus.bearing) / (2.0 * kStep);
  }
  const Eigen::Matrix2d expected = J * covariance * J.transpose();
  EXPECT_TRUE(toHorizontal(tilt, z, covariance).covariance.isApprox(expected, 1e-7));
}

}  // namespace
}  // namespace slam::eval
