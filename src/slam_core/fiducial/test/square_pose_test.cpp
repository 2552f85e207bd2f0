// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/square_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "slam_core/common/random.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"

namespace slam::fiducial {
namespace {

Corners project(const Eigen::Isometry3d& T_camera_marker, double size) {
  Corners on_plane;
  const auto square = cornersOfSquare(size);
  for (std::size_t i = 0; i < 4; ++i) on_plane[i] = (T_camera_marker * square[i]).hnormalized();
  return on_plane;
}

std::vector<Eigen::Isometry3d> manyPoses() {
  std::vector<Eigen::Isometry3d> poses;
  for (const double distance : {0.4, 1.0, 4.0})
    for (const double x : {-0.5, 0.0, 0.3})
      for (const double obliqueness : {0.1, 0.6, 1.2})
        for (const double axis : {0.0, 1.0, 2.5, 4.0})
          poses.push_back(
              test::facing(distance * Eigen::Vector3d(x, 0.2 * x + 0.05, 1.0), obliqueness, axis));
  return poses;
}

TEST(SquarePose, FindsTheTruePoseOfPerfectCorners) {
  for (const auto& truth : manyPoses()) {
    const auto poses = posesOfSquare(project(truth, 0.2), 0.2);
    ASSERT_TRUE(poses);
    const auto isTruth = [&](const auto& pose) { return pose.isApprox(truth, 1e-6); };
    EXPECT_TRUE(isTruth((*poses)[0]) || isTruth((*poses)[1])) << truth.matrix();
  }
}

TEST(SquarePose, FindsRotationsSeenFromTheFrontExactly) {
  const auto truth = test::facing({0.0, 0.0, 1.0});
  const auto poses = posesOfSquare(project(truth, 0.2), 0.2);
  ASSERT_TRUE(poses);
  for (const auto& pose : *poses) EXPECT_TRUE(pose.isApprox(truth, 1e-6)) << pose.matrix();
}

TEST(SquarePose, FindsTheSamePairAsOpenCv) {
  RandomStream random(3, 0);
  for (const auto& truth : manyPoses()) {
    auto on_plane = project(truth, 0.2);
    for (auto& corner : on_plane)
      corner += 3e-4 * Eigen::Vector2d(random.gaussian(), random.gaussian());
    const auto poses = posesOfSquare(on_plane, 0.2);
    ASSERT_TRUE(poses);
    std::vector<cv::Point3d> square;
    std::vector<cv::Point2d> pixels;
    for (const auto& corner : cornersOfSquare(0.2))
      square.emplace_back(corner.x(), corner.y(), corner.z());
    for (const auto& corner : on_plane) pixels.emplace_back(corner.x(), corner.y());
    std::vector<cv::Mat> rotations, translations;
    cv::solvePnPGeneric(square, pixels, cv::Matx33d::eye(), cv::noArray(), rotations, translations,
                        false, cv::SOLVEPNP_IPPE_SQUARE);
    ASSERT_EQ(translations.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::Vector3d theirs(translations[i].at<double>(0), translations[i].at<double>(1),
                                   translations[i].at<double>(2));
      const double away = std::min(((*poses)[0].translation() - theirs).norm(),
                                   ((*poses)[1].translation() - theirs).norm());
      EXPECT_LT(away, 1e-4 * theirs.norm());
    }
  }
}

TEST(SquarePose, RefusesCornersInLine) {
  EXPECT_FALSE(posesOfSquare({Eigen::Vector2d(0, 0), {1, 0}, {2, 0}, {3, 0}}, 0.2));
  EXPECT_FALSE(posesOfSquare({Eigen::Vector2d(1, 1), {1, 1}, {1, 1}, {1, 1}}, 0.2));
}

}  // namespace
}  // namespace slam::fiducial
