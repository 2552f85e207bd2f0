// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/inverse_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam::mono_ekf {
namespace {

const auto kMinus = [](const auto& a, const auto& b) { return (a - b).eval(); };

InverseDepth someFeature() { return (InverseDepth() << 0.7, -1.2, 0.9, -0.25, 0.4).finished(); }

TEST(InverseDepthOfAPoint, IsThePointAtItsDistance) {
  const InverseDepth straight = (InverseDepth() << 1.0, 2.0, 0.0, 0.0, 0.5).finished();
  EXPECT_LT((pointOf(straight, 0.3) - Eigen::Vector3d(3.0, 2.0, 0.3)).norm(), 1e-12);
  const InverseDepth up = (InverseDepth() << 1.0, 2.0, 0.0, M_PI / 2, 0.5).finished();
  EXPECT_LT((pointOf(up, 0.3) - Eigen::Vector3d(1.0, 2.0, 2.3)).norm(), 1e-12);
}

TEST(InverseDepthOfAPoint, HasTheJacobiansOfNumericDerivatives) {
  const auto feature = someFeature();
  const Eigen::Vector3d centre_now(0.2, 0.5, 0.65);
  Eigen::Matrix<double, 3, 5> J_point, J_vector;
  pointOf(feature, 0.65, &J_point);
  scaledVector(feature, 0.65, centre_now, &J_vector);
  const auto point = test::numericJacobian(
      [](const Eigen::VectorXd& y) { return pointOf(InverseDepth(y), 0.65); }, feature, kMinus);
  const auto vector = test::numericJacobian(
      [&](const Eigen::VectorXd& y) { return scaledVector(InverseDepth(y), 0.65, centre_now); },
      feature, kMinus);
  EXPECT_LT((J_point - point).norm(), 1e-6);
  EXPECT_LT((J_vector - vector).norm(), 1e-6);
}

TEST(InverseDepthOfAPoint, LooksTheSameWayAsTheVectorToThePoint) {
  const auto feature = someFeature();
  const Eigen::Vector3d centre_now(0.2, 0.5, 0.65);
  const Eigen::Vector3d vector = pointOf(feature, 0.65) - centre_now;
  EXPECT_LT((scaledVector(feature, 0.65, centre_now) - 0.4 * vector).norm(), 1e-12);
  auto far = feature;
  far(4) = 0.0;
  EXPECT_LT((scaledVector(far, 0.65, centre_now) - directionOf(far(2), far(3))).norm(), 1e-12)
      << "at infinity it is the ray";
}

TEST(LinearityIndex, FallsWithParallaxAndWithTheDoubtInDepth) {
  const InverseDepth feature = (InverseDepth() << 0.0, 0.0, 0.0, 0.0, 0.5).finished();  // 2 m ahead
  const double near_start = linearityIndex(feature, 0.0, 0.05, {0.0, 0.0, 0.0});
  EXPECT_NEAR(near_start, 4.0 * 0.05 / 0.25 / 2.0, 1e-12) << "Eq. 31 without parallax";
  EXPECT_LT(linearityIndex(feature, 0.0, 0.05, {0.0, 2.0, 0.0}), near_start);
  EXPECT_LT(linearityIndex(feature, 0.0, 0.01, {0.0, 0.0, 0.0}), near_start);
  EXPECT_TRUE(std::isinf(linearityIndex(0.0 * feature, 0.0, 0.05, {1.0, 0.0, 0.0})));
}

}  // namespace
}  // namespace slam::mono_ekf
