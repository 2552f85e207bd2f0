// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/range_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::fiducial {
namespace {

const Eigen::Matrix3d kNoise = Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal();

Eigen::Matrix3d rotation(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}
const Eigen::Matrix3d kAhead = rotation(-M_PI / 2, 0, -M_PI / 2);

TEST(RangeAndBearing, AreThoseInTheHorizontalPlane) {
  // 1 m to the right of a camera that looks ahead, 2 m away, 0.7 m above
  const auto z = rangeAndBearing({1.0, -0.7, 2.0}, kNoise, kAhead, 0.1);
  ASSERT_TRUE(z);
  EXPECT_NEAR(z->range, std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(z->bearing, -std::atan2(1.0, 2.0), 1e-12);
}

TEST(RangeAndBearing, FollowTheCameraWhereverItLooks) {
  const auto bearingOf = [](const Eigen::Matrix3d& R) {
    return rangeAndBearing({0, 0, 2.0}, kNoise, R, 0.1)->bearing;
  };
  EXPECT_NEAR(bearingOf(kAhead), 0.0, 1e-12);
  EXPECT_NEAR(bearingOf(rotation(0, 0, 2.0) * kAhead), 2.0, 1e-12);
  EXPECT_NEAR(std::abs(bearingOf(rotation(0, 0, M_PI) * kAhead)), M_PI, 1e-12);
  const auto up = rangeAndBearing({0, 0, 2.0}, kNoise, rotation(0, -M_PI / 4, 0) * kAhead, 0.1);
  EXPECT_NEAR(up->range, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(up->bearing, 0.0, 1e-12);
}

TEST(RangeAndBearing, TurnTheCovarianceIntoTheirAxes) {
  const auto ahead = rangeAndBearing({0, 0, 2.0}, kNoise, kAhead, 0.1);
  EXPECT_NEAR(ahead->covariance(0, 0), 4e-4, 1e-12) << "depth";
  EXPECT_NEAR(ahead->covariance(1, 1), 1e-4 / 4.0, 1e-12) << "sideways, over the range squared";
  EXPECT_NEAR(ahead->covariance(0, 1), 0.0, 1e-12);
  const auto left = rangeAndBearing({0, 0, 2.0}, kNoise, rotation(0, 0, 1.0) * kAhead, 0.1);
  EXPECT_TRUE(left->covariance.isApprox(ahead->covariance, 1e-9));
}

TEST(RangeAndBearing, AreNoneRightAboveACameraThatLooksUp) {
  const Eigen::Matrix3d up = Eigen::Matrix3d::Identity();
  EXPECT_FALSE(rangeAndBearing({0, 0, 2.0}, kNoise, up, 0.1));
  EXPECT_FALSE(rangeAndBearing({0.09, 0, 2.0}, kNoise, up, 0.1)) << "0.01 m of 0.09 m";
  const auto z = rangeAndBearing({0, 0.11, 2.0}, kNoise, up, 0.1);
  ASSERT_TRUE(z);
  EXPECT_NEAR(z->range, 0.11, 1e-12);
  EXPECT_NEAR(z->bearing, M_PI / 2, 1e-12);
}

TEST(RangeAndBearing, AreNoneOfWhatIsNoNumber) {
  EXPECT_FALSE(rangeAndBearing({NAN, 0, 2.0}, kNoise, kAhead, 0.1));
  EXPECT_FALSE(rangeAndBearing({1, 0, 2.0}, NAN * kNoise, kAhead, 0.1));
}

}  // namespace
}  // namespace slam::fiducial
