// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/normalised_camera.hpp"

#include <gtest/gtest.h>

#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam {
namespace {

/// Looks ahead and a little down, beside the robot's centre.
NormalisedCamera camera() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T.linear() = T.linear() * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  T.translation() << 0.2, -0.1, 0.7;
  return NormalisedCamera(T);
}

const Pose2 kPose(1.0, -2.0, 0.7);

TEST(NormalisedCamera, SeesAPointAlongItsRay) {
  const Eigen::Vector2d seen(0.2, -0.1);
  const Eigen::Vector3d point = camera().centre(kPose) + 2.5 * camera().ray(kPose, seen);
  const auto again = camera().project(kPose, point);
  ASSERT_TRUE(again.has_value());
  EXPECT_LT((*again - seen).norm(), 1e-12);
  EXPECT_NEAR(camera().inCamera(kPose, point).z(), 2.5, 1e-12);
}

TEST(NormalisedCamera, SeesNothingBehindIt) {
  const Eigen::Vector3d behind = camera().centre(kPose) - camera().ray(kPose, {0.0, 0.0});
  EXPECT_FALSE(camera().project(kPose, behind).has_value());
  EXPECT_FALSE(camera().project(kPose, camera().centre(kPose)).has_value());
}

TEST(NormalisedCamera, HasTheJacobiansOfItsProjection) {
  const Eigen::Vector3d point = camera().centre(kPose) + 2.0 * camera().ray(kPose, {0.3, 0.1});
  Eigen::Matrix<double, 2, 3> J_pose, J_point;
  camera().project(kPose, point, &J_pose, &J_point);
  const auto minus = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a - b; };
  const auto by_pose = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return *camera().project(Pose2::fromVector(x), point);
  };
  const auto by_point = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return *camera().project(kPose, x);
  };
  EXPECT_LT((J_pose - test::numericJacobian(by_pose, kPose.vector(), minus)).norm(), 1e-6);
  EXPECT_LT((J_point - test::numericJacobian(by_point, point, minus)).norm(), 1e-6);
}

}  // namespace
}  // namespace slam
