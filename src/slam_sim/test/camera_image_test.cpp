// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "slam_sim/studio.hpp"
#include "tag_reader.hpp"

namespace slam::sim {
namespace {

const cv::Rect kMiddle(280, 200, 80, 80);

bool same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

double meanOf(const cv::Mat& image, const cv::Rect& part) { return cv::mean(image(part))[0]; }

/// RMS difference of horizontal neighbours.
double sharpness(const cv::Mat& image) {
  const auto right = image.colRange(1, image.cols), left = image.colRange(0, image.cols - 1);
  return cv::norm(right, left, cv::NORM_L2) / std::sqrt(static_cast<double>(right.total()));
}

cv::Mat picture(const World& world, const CameraOptics& optics, const CameraPath& path,
                std::uint64_t frame = 0) {
  return studioCamera(world, optics).render(path, RandomStream(1, frame));
}

CameraOptics quiet() {
  CameraOptics optics;
  optics.noise_sigma = 0.0;
  return optics;
}

TEST(CameraImage, IsAFunctionOfPathAndNoiseOnAnyThread) {
  const auto camera = studioCamera(studioWorld("36h11", 1));
  const auto path = standing(cameraBefore(1.0, 0.3));
  const auto image = camera.render(path, RandomStream(1, 2));
  cv::Mat elsewhere;
  std::thread([&] { elsewhere = camera.render(path, RandomStream(1, 2)); }).join();
  EXPECT_TRUE(same(image, elsewhere));
  EXPECT_TRUE(same(image, studioCamera(studioWorld("36h11", 1)).render(path, RandomStream(1, 2))));
  EXPECT_FALSE(same(image, camera.render(path, RandomStream(1, 3))));
  EXPECT_FALSE(same(image, camera.render(path, RandomStream(2, 2))));
}

TEST(CameraImage, HasNoiseOfThatSigmaThatIsWhite) {
  const auto world = studioWorld("36h11", 1);
  const auto path = standing(cameraBefore(1.0, 0.0));
  CameraOptics optics;
  optics.noise_sigma = 3.0;
  cv::Mat first, second, difference;
  picture(world, optics, path, 1).convertTo(first, CV_32F);
  picture(world, optics, path, 2).convertTo(second, CV_32F);
  cv::subtract(first, second, difference);
  cv::Scalar mean, deviation;
  cv::meanStdDev(difference, mean, deviation);
  const double rounding = 2.0 / 12.0;
  EXPECT_NEAR(deviation[0] * deviation[0], 2.0 * 9.0 + rounding, 0.3);
  EXPECT_NEAR(mean[0], 0.0, 0.03);
  const auto neighbours = difference.colRange(1, 640).mul(difference.colRange(0, 639));
  EXPECT_NEAR(cv::mean(neighbours)[0] / 18.0, 0.0, 0.02);
}

TEST(CameraImage, IsBlurredAlongTheMotionWithinTheExposure) {
  const auto world = studioWorld("36h11", 1);
  const auto T = cameraBefore(1.0, 0.0);
  const double shift = 0.012;  // 6 px
  const CameraPath sideways = [&](double part) {
    return T * Eigen::Translation3d((part - 0.5) * shift, 0.0, 0.0);
  };
  const auto still = picture(world, quiet(), standing(T))(kMiddle).clone();
  const auto moved = picture(world, quiet(), sideways)(kMiddle).clone();
  EXPECT_LT(sharpness(moved), 0.75 * sharpness(still));
  EXPECT_GT(sharpness(moved.t()), 0.8 * sharpness(still.t()));
  EXPECT_NEAR(cv::mean(moved)[0], cv::mean(still)[0], 1.5);
}

TEST(CameraImage, BecomesDarkerAndSofterAsToldTo) {
  const auto world = studioWorld("36h11", 1);
  const auto path = standing(cameraBefore(1.0, 0.0));
  const auto image = picture(world, quiet(), path);
  CameraOptics optics = quiet();
  optics.brightness = 0.5;
  EXPECT_NEAR(meanOf(picture(world, optics, path), kMiddle) / meanOf(image, kMiddle), 0.5, 0.01);
  optics = quiet();
  optics.defocus_sigma = 2.0;
  EXPECT_LT(sharpness(picture(world, optics, path)(kMiddle)), 0.7 * sharpness(image(kMiddle)));
  optics = quiet();
  optics.vignetting = 0.0;
  const cv::Rect corner(0, 0, 20, 20);
  EXPECT_NEAR(meanOf(image, corner) / meanOf(picture(world, optics, path), corner), 0.7, 0.03);
}

TEST(CameraImage, HidesAMarkerBehindAWallAndBehindFurniture) {
  const auto path = standing(cameraBefore(1.0, 0.0));
  World world = studioWorld("36h11", 1);
  EXPECT_EQ(readMarkers(picture(world, {}, path), "36h11").size(), 1U);
  world.walls.push_back({{0.5, -1.0}, {0.5, 1.0}, 2.5, 0.7});
  EXPECT_EQ(readMarkers(picture(world, {}, path), "36h11").size(), 0U);
  world.walls.back().height = 0.5;
  EXPECT_EQ(readMarkers(picture(world, {}, path), "36h11").size(), 1U);
  world.furniture.push_back({{0.5, 0.08}, 0.3, {0.2, 0.2, 1.5}, 0.5});
  EXPECT_EQ(readMarkers(picture(world, {}, path), "36h11").size(), 0U);
  world.furniture.back().centre.y() = 0.5;
  EXPECT_EQ(readMarkers(picture(world, {}, path), "36h11").size(), 1U);
}

TEST(CameraImage, ShowsAMarkerFromItsFaceOnly) {
  World world = studioWorld("36h11", 1);
  world.markers[0].T_world_marker = uprightMarker({0.002, 0.0, 1.0}, M_PI);
  const auto image = picture(world, quiet(), standing(cameraBefore(1.0, 0.0)));
  EXPECT_GT(meanOf(image, kMiddle), 100.0);
  EXPECT_LT(sharpness(image(kMiddle)), 4.0);
}

TEST(CameraImage, OfTheCeilingHasManyCorners) {
  World world = studioWorld("36h11", 1);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();  // the optical axis is the world's z
  T.translation() = Eigen::Vector3d(1.0, 0.5, 0.5);
  for (const std::string texture : {"tiles", "plaster"}) {
    world.ceiling.texture = texture;
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(picture(world, {}, standing(T)), corners, 1000, 0.05, 8.0);
    EXPECT_GT(corners.size(), 200U) << texture;
  }
}

TEST(CameraImage, StaysSmallAsJpegDespiteTheNoise) {
  const auto image = picture(studioWorld("36h11", 1), {}, standing(cameraBefore(1.0, 0.3)));
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 80});
  EXPECT_LT(jpeg.size(), 60000U);  // 1500 of them are 90 MB
}

TEST(CameraImage, IsNumbersFromAnyPlaceInAnEmptyWorld) {
  World world;
  for (const double z : {-1.0, 0.0, 1.0, 2.5, 4.0}) {
    Eigen::Isometry3d T = cameraBefore(1.0, 0.0);
    T.translation().z() = z;
    const auto image = picture(world, quiet(), standing(T));
    EXPECT_EQ(image.size(), cv::Size(640, 480));
    EXPECT_GT(cv::mean(image)[0], 5.0);
  }
}

}  // namespace
}  // namespace slam::sim
