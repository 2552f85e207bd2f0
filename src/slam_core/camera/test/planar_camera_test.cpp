// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/planar_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam {
namespace {

const auto kMinus = [](const auto& a, const auto& b) { return (a - b).eval(); };

/// A camera that looks ahead and a little down, with some roll, off the robot's centre.
PlanarCamera tiltedCamera() {
  const CameraCalibration calibration{
      640, 480, "plumb_bob", 540.0, 545.0, 321.4, 238.7, {0.12, -0.25, 0.001, -0.0005, 0.0}};
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  mount.linear() = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) * mount.linear() *
                   Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ());
  mount.translation() << 0.1, -0.05, 0.65;
  return {std::make_shared<const CameraModel>(calibration), mount};
}

TEST(PlanarCamera, SeesWhatIsAheadInItsMiddle) {
  const CameraCalibration calibration{640, 480, "", 500.0, 500.0, 320.0, 240.0, {}};
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  mount.translation() << 0.0, 0.0, 0.5;
  const PlanarCamera camera(std::make_shared<const CameraModel>(calibration), mount);
  const Pose2 robot(1.0, 2.0, M_PI / 2);  // looks along y
  const auto projection = camera.project(robot, Eigen::Vector3d(0.2, 2.0, 0.4));
  ASSERT_TRUE(projection);
  EXPECT_NEAR(projection->pixel.x(), 370.0, 1e-9) << "x of the map is to the right";
  EXPECT_NEAR(projection->pixel.y(), 140.0, 1e-9) << "up is up";
  EXPECT_FALSE(camera.project(robot, Eigen::Vector3d(0.2, -2.0, 0.4))) << "behind";
  EXPECT_LT((camera.centre(robot) - Eigen::Vector3d(1.0, 2.0, 0.5)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(camera.height(), 0.5);
}

TEST(PlanarCamera, HasTheJacobiansOfNumericDerivatives) {
  const auto camera = tiltedCamera();
  const Eigen::Vector3d vector(2.0, 1.1, -0.3);
  const Pose2 robot(0.4, -0.7, 0.3);
  const auto projection = camera.project(robot, vector);
  ASSERT_TRUE(projection);
  const auto of_vector = test::numericJacobian(
      [&](const Eigen::VectorXd& v) { return camera.project(robot, v.head<3>())->pixel; }, vector,
      kMinus);
  EXPECT_LT((projection->J_vector - of_vector).norm(), 1e-4);
  const auto of_theta = test::numericJacobian(
      [&](const Eigen::VectorXd& theta) {
        return camera.project(Pose2(0.4, -0.7, theta(0)), vector)->pixel;
      },
      Eigen::VectorXd::Constant(1, 0.3), kMinus);
  EXPECT_LT((projection->J_theta - of_theta).norm(), 1e-4);
  Eigen::Matrix3d J_centre;
  camera.centre(robot, &J_centre);
  const auto of_centre = test::numericJacobian(
      [&](const Eigen::VectorXd& pose) { return camera.centre(Pose2::fromVector(pose.head<3>())); },
      robot.vector(), kMinus);
  EXPECT_LT((J_centre - of_centre).norm(), 1e-6);
}

TEST(PlanarCamera, LooksAlongTheRayOfAPixelThatSeesIt) {
  const auto camera = tiltedCamera();
  const Pose2 robot(3.0, 1.0, -2.0);
  for (double u = 20.0; u < 640.0; u += 120.0)
    for (double v = 20.0; v < 480.0; v += 110.0) {
      const auto ray = camera.ray(robot, {u, v});
      ASSERT_TRUE(ray);
      EXPECT_NEAR(ray->norm(), 1.0, 1e-12);
      const auto again = camera.project(robot, 7.0 * *ray);
      ASSERT_TRUE(again);
      EXPECT_LT((again->pixel - Eigen::Vector2d(u, v)).norm(), 1e-6);
    }
}

}  // namespace
}  // namespace slam
