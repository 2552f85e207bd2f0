// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam {
namespace {

CameraCalibration camera(const std::string& model, const std::vector<double>& distortion) {
  return {640, 480, model, 420.0, 425.0, 315.2, 243.7, distortion};
}

std::vector<CameraCalibration> cameras() {
  return {camera("", {}), camera("plumb_bob", {-0.3, 0.12, 0.001, -0.0007, 0.01}),
          camera("plumb_bob", {0.1, -0.05, 0.0, 0.0}),
          camera("rational_polynomial", {0.5, 0.1, 3e-4, -2e-4, 0.01, 0.8, 0.2, 0.02}),
          camera("equidistant", {-0.02, 0.006, -0.003, 0.0005})};
}

/// The same by OpenCV.
cv::Point2d projectedByOpenCv(const CameraCalibration& c, const Eigen::Vector3d& point) {
  const cv::Matx33d K(c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  const std::vector<cv::Point3d> points = {{point.x(), point.y(), point.z()}};
  std::vector<cv::Point2d> pixels;
  const cv::Vec3d zero(0, 0, 0);
  if (c.distortion_model == "equidistant")
    cv::fisheye::projectPoints(points, pixels, zero, zero, K, c.distortion);
  else
    cv::projectPoints(points, zero, zero, K, c.distortion, pixels);
  return pixels[0];
}

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  for (const auto& calibration : cameras()) {
    const CameraModel model(calibration);
    for (double x = -0.6; x <= 0.6; x += 0.15) {
      for (double y = -0.5; y <= 0.5; y += 0.25) {
        const Eigen::Vector3d point(2.0 * x, 2.0 * y, 2.0);
        const auto pixel = model.project(point);
        const auto expected = projectedByOpenCv(calibration, point);
        ASSERT_TRUE(pixel) << calibration.distortion_model << " at " << x << ", " << y;
        EXPECT_NEAR(pixel->x(), expected.x, 1e-9) << calibration.distortion_model;
        EXPECT_NEAR(pixel->y(), expected.y, 1e-9) << calibration.distortion_model;
      }
    }
  }
}

TEST(CameraModel, UnprojectsEveryPixelOfTheImageToWhereItCameFrom) {
  for (const auto& calibration : cameras()) {
    const CameraModel model(calibration);
    for (int u = 0; u < calibration.width; u += 71) {
      for (int v = 0; v < calibration.height; v += 53) {
        const auto on_plane = model.unproject(Eigen::Vector2d(u, v));
        ASSERT_TRUE(on_plane) << calibration.distortion_model << " at " << u << ", " << v;
        const auto again = model.project(3.0 * on_plane->homogeneous());
        ASSERT_TRUE(again);
        EXPECT_LT((*again - Eigen::Vector2d(u, v)).norm(), 1e-8) << calibration.distortion_model;
      }
    }
  }
}

TEST(CameraModel, HasTheJacobianOfItsProjection) {
  for (const auto& calibration : cameras()) {
    const CameraModel model(calibration);
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.4, -0.3, 1.5),
                                         Eigen::Vector3d(-0.8, 0.5, 2)}) {
      Eigen::Matrix<double, 2, 3> J;
      ASSERT_TRUE(model.project(point, &J));
      const auto numeric = test::numericJacobian(
          [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return *model.project(Eigen::Vector3d(x));
          },
          point, [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a - b; });
      EXPECT_TRUE(J.isApprox(numeric, 1e-6)) << calibration.distortion_model << "\n"
                                             << J << "\n"
                                             << numeric;
    }
  }
}

TEST(CameraModel, SeesNothingBehindItself) {
  for (const auto& calibration : cameras()) {
    const CameraModel model(calibration);
    EXPECT_FALSE(model.project({0.1, 0.1, -1.0}));
    EXPECT_FALSE(model.project({0.1, 0.1, 0.0}));
    EXPECT_FALSE(model.project({NAN, 0.1, 1.0}));
  }
}

TEST(CameraModel, HasNoImageOfPointsBeyondWhereThePolynomialFoldsBack) {
  // r (1 - 0.5 r^2) grows up to r = 0.816 and comes back to the middle of the image at 1.41
  const CameraModel model(camera("plumb_bob", {-0.5, 0, 0, 0, 0}));
  EXPECT_TRUE(model.project({0.80, 0.0, 1.0}));
  EXPECT_FALSE(model.project({0.83, 0.0, 1.0}));
  EXPECT_FALSE(model.project({1.41, 0.0, 1.0}));
  EXPECT_FALSE(model.unproject({315.2 + 420.0 * 0.6, 243.7})) << "no point is seen there";
  EXPECT_TRUE(model.unproject({315.2 + 420.0 * 0.54, 243.7}));
}

TEST(CameraCalibration, IsRefusedWithTheReason) {
  const auto good = camera("plumb_bob", {0, 0, 0, 0, 0});
  const auto faultWith = [&](auto&& change) {
    auto bad = good;
    change(bad);
    return faultOf(bad);
  };
  EXPECT_EQ(faultOf(good), "");
  const auto says = [](const std::string& fault, const std::string& words) {
    return fault.find(words) != std::string::npos;
  };
  EXPECT_TRUE(says(faultWith([](auto& c) { c.fx = c.fy = c.cx = c.cy = 0; }), "not calibrated"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.fx = -1; }), "focal"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.fy = NAN; }), "focal"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.cy = INFINITY; }), "principal point"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.width = 0; }), "size"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.fx = c.fy = 0.8; }), "of 0.8 and 0.8 px fit no lens"))
      << "normalised units";
  EXPECT_TRUE(says(faultWith([](auto& c) { c.fy = 1e12; }), "fit no lens"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.cx = -1e9; }), "principal point is at (-1e+09"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.cx = 1.4 * c.width; }), "far from an image"));
  EXPECT_EQ(faultWith([](auto& c) { c.cx = 1.1 * c.width; }), "") << "a lens that is shifted";
  EXPECT_EQ(faultWith([](auto& c) {
              c.width = c.height = 8;
              c.is_region = true;
            }),
            "");
  EXPECT_TRUE(says(faultWith([](auto& c) { c.distortion_model = "plump_bob"; }),
                   "did you mean 'plumb_bob'"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.distortion = {1, 2, 3}; }), "3 coefficients"));
  EXPECT_TRUE(says(faultWith([](auto& c) { c.distortion[2] = NAN; }), "not a number"));
}

TEST(CameraCalibration, IsRefusedWithADistortionOfNoLens) {
  for (const auto& good : cameras()) EXPECT_EQ(faultOf(good), "") << good.distortion_model;
  EXPECT_EQ(faultOf(camera("plumb_bob", {-0.5, 0, 0, 0, 0})), "") << "it folds near the corners";
  EXPECT_EQ(faultOf({640, 480, "equidistant", 130.0, 130.0, 320.0, 240.0, {0, 0, 0, 0}}), "")
      << "it sees more than a half space";
  const std::string reason = "its distortion coefficients bend the image as no lens does";
  for (const double wild : {1e6, -1e6, 300.0, -300.0})
    for (const std::size_t which : {0, 1, 2, 3}) {
      std::vector<double> coefficients(4, 0.0);
      coefficients[which] = wild;
      if (which == 1 && std::abs(wild) < 1e3) continue;  // r^4 is small near the middle
      EXPECT_EQ(faultOf(camera("plumb_bob", coefficients)), reason) << which << ' ' << wild;
      if (which >= 2) continue;
      EXPECT_EQ(faultOf(camera("equidistant", coefficients)), reason);
    }
}

}  // namespace
}  // namespace slam
