// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "slam_sim/studio.hpp"

namespace slam::sim {
namespace {

/// A wall of that texture, seen by a camera 1 m above the floor.
World roomOf(const std::string& texture) {
  World world;
  Wall wall{{0.0, -12.0}, {0.0, 12.0}, 2.5, 0.7};
  wall.texture = texture;
  wall.look = 1;
  world.walls = {wall};
  return world;
}

cv::Mat seen(const World& world, const Eigen::Isometry3d& T, const CameraOptics& optics = {}) {
  return studioCamera(world, optics).render(standing(T), RandomStream(1, 1));
}

/// Counts the corners that FAST finds on the wall after the image's noise is smoothed.
std::size_t cornersOn(const cv::Mat& image, const cv::Rect& part) {
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, cv::Size(), 1.0);
  std::vector<cv::KeyPoint> corners;
  cv::FAST(smooth(part), corners, 12);
  return corners.size();
}

/// The rows of the image that the wall fills at a distance.
cv::Rect wallAt(double distance) {
  const int up = std::min(236, static_cast<int>(1.3 * 520.0 / distance));
  const int down = std::min(240, static_cast<int>(0.9 * 520.0 / distance));
  return {60, 236 - up, 520, up + down};
}

TEST(VisibleFeatures, AreThereFromNearAndFromAfar) {
  for (const std::string texture : {"posters", "mural", "brick"}) {
    const auto world = roomOf(texture);
    for (const double distance : {0.6, 1.0, 2.0, 4.0, 8.0}) {
      const auto image = seen(world, cameraBefore(distance, 0.0));
      EXPECT_GT(cornersOn(image, wallAt(distance)), 20U) << texture << " at " << distance << " m";
    }
  }
  const auto plain = roomOf("plaster");
  EXPECT_LT(cornersOn(seen(plain, cameraBefore(2.0, 0.0)), wallAt(2.0)), 10U);
}

TEST(VisibleFeatures, AreThereObliquelyAndUnderAMovingCamera) {
  const auto world = roomOf("posters");
  EXPECT_GT(cornersOn(seen(world, cameraBefore(2.0, 1.0)), {60, 100, 520, 280}), 20U);
  CameraOptics slow;
  slow.exposure = 0.02;
  const auto T = cameraBefore(2.0, 0.0);
  const CameraPath turning = [&](double part) {
    return T * Eigen::AngleAxisd((part - 0.5) * 0.01, Eigen::Vector3d::UnitY());
  };
  const auto blurred = studioCamera(world, slow).render(turning, RandomStream(1, 1));
  const auto sharp = studioCamera(world, slow).render(standing(T), RandomStream(1, 1));
  EXPECT_GT(cornersOn(blurred, wallAt(2.0)), 20U);
  EXPECT_LT(cornersOn(blurred, wallAt(2.0)), cornersOn(sharp, wallAt(2.0)));
}

/// Fitting descriptors of two pictures that a homography explains.
int explained(const cv::Mat& from, const cv::Mat& to, double shift) {
  const auto orb = cv::ORB::create(500);
  std::vector<cv::KeyPoint> points[2];
  cv::Mat descriptors[2];
  orb->detectAndCompute(from, {}, points[0], descriptors[0]);
  orb->detectAndCompute(to, {}, points[1], descriptors[1]);
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(descriptors[0], descriptors[1], matches);
  int right = 0;
  for (const auto& match : matches) {
    const auto a = points[0][static_cast<std::size_t>(match.queryIdx)].pt;
    const auto b = points[1][static_cast<std::size_t>(match.trainIdx)].pt;
    right += std::hypot(b.x - a.x - shift, b.y - a.y) < 6.0 ? 1 : 0;
  }
  return right;
}

TEST(VisibleFeatures, AreTheSameOnesFromAnotherPlace) {
  const auto world = roomOf("posters");
  const auto T = cameraBefore(2.0, 0.0);
  const auto beside = T * Eigen::Translation3d(0.2, 0.0, 0.0);
  const double shift = -0.2 * 520.0 / 2.0;
  EXPECT_GT(explained(seen(world, T), seen(world, beside), shift), 100);
}

TEST(VisibleFeatures, OfTwoWallsLookAlikeWithOneLookOnly) {
  auto world = roomOf("posters");
  const auto T = cameraBefore(2.0, 0.0);
  const auto once = seen(world, T);
  EXPECT_EQ(cv::norm(once, seen(world, T), cv::NORM_INF), 0.0);
  world.walls[0].look = 2;
  EXPECT_GT(cv::norm(once, seen(world, T), cv::NORM_L1) / static_cast<double>(once.total()), 10.0);
}

TEST(VisibleFeatures, OfFloorsAreThereAndRepeatOnTiles) {
  Eigen::Isometry3d T = cameraBefore(1.0, 0.0);
  T.linear() = T.linear() * Eigen::AngleAxisd(-0.6, Eigen::Vector3d::UnitX());
  for (const std::string texture : {"tiles", "parquet", "terrazzo"}) {
    World world;
    world.floor_texture = texture;
    EXPECT_GT(cornersOn(seen(world, T), {40, 200, 560, 260}), 20U) << texture;
  }
  World tiled;
  tiled.floor_texture = "tiles";
  const auto far = Eigen::Translation3d(1.6, 0.0, 0.0) * T;  // one period of the pattern
  CameraOptics quiet;
  quiet.noise_sigma = 0.0;
  const cv::Rect floor(100, 330, 400, 140);
  const auto here = seen(tiled, T, quiet)(floor).clone(), there = seen(tiled, far, quiet)(floor);
  EXPECT_LT(cv::norm(here, there, cv::NORM_L1) / static_cast<double>(here.total()), 6.0);
}

TEST(VisibleFeatures, ADoorLooksLikeEveryOther) {
  auto world = roomOf("plaster");
  world.doors = {{{0.0, 1.0}, 0.0}, {{0.0, -3.0}, 0.0}};
  const auto T = cameraBefore(2.0, 0.0);
  CameraOptics quiet;
  quiet.noise_sigma = 0.0;
  const auto first = seen(world, Eigen::Translation3d(0.0, 1.0, 0.0) * T, quiet);
  const auto second = seen(world, Eigen::Translation3d(0.0, -3.0, 0.0) * T, quiet);
  const cv::Rect leaf(220, 60, 200, 400);
  EXPECT_GT(cornersOn(first, leaf), 4U);
  const auto ratio = cv::mean(first(leaf))[0] / cv::mean(second(leaf))[0];
  cv::Mat scaled;
  second(leaf).convertTo(scaled, CV_8U, ratio);  // lamps light the one more than the other
  EXPECT_LT(cv::norm(first(leaf), scaled, cv::NORM_L1) / static_cast<double>(scaled.total()), 6.0);
}

TEST(VisibleFeatures, AllOfADoorIsItsPicture) {
  auto world = roomOf("plaster");
  world.walls[0].gray = 1.0;
  world.doors = {{{0.0, 0.0}, 0.0, 1.3, 2.3}};
  CameraOptics quiet;
  quiet.noise_sigma = 0.0;
  const auto image = seen(world, cameraBefore(2.0, 0.0), quiet);
  // The sill, below the leaf's panels: one tone from side to side.
  cv::Scalar mean, deviation;
  cv::meanStdDev(image(cv::Rect(290, 486 - 20, 60, 8)), mean, deviation);
  EXPECT_LT(deviation[0], 4.0);
}

TEST(RollingShutter, LeansWhatATurningCameraSees) {
  auto world = roomOf("plaster");
  world.doors = {{{0.0, 0.0}, 0.0}};
  CameraOptics rolling;
  rolling.noise_sigma = 0.0;
  rolling.rolling_shutter = 0.03;
  const auto T = cameraBefore(2.0, 0.0);
  const CameraPath turning = [&](double part) {
    return T * Eigen::AngleAxisd((part - 0.5) * 0.04, Eigen::Vector3d::UnitY());
  };
  // The column of the strongest edge at the left of the door, in some rows.
  const auto edgeOf = [](const cv::Mat& image, int row) {
    cv::Mat slope;
    cv::Sobel(image, slope, CV_32F, 1, 0);
    slope = cv::abs(slope);
    cv::Point at;
    cv::Mat band;
    cv::reduce(slope.rowRange(row - 4, row + 4).colRange(150, 260), band, 0, cv::REDUCE_AVG);
    cv::minMaxLoc(band, nullptr, nullptr, nullptr, &at);
    return at.x;
  };
  const auto leaning = studioCamera(world, rolling).render(turning, RandomStream(1, 1));
  rolling.rolling_shutter = 0.0;
  const auto upright = studioCamera(world, rolling).render(standing(T), RandomStream(1, 1));
  EXPECT_NEAR(edgeOf(upright, 100), edgeOf(upright, 380), 6);  // what the lens bends
  // 280 of 480 rows in 3/4 of a turn by 0.04 rad at 520 px a radian.
  const double lean = edgeOf(leaning, 380) - edgeOf(leaning, 100);
  const double bent = edgeOf(upright, 380) - edgeOf(upright, 100);
  EXPECT_NEAR(lean - bent, -520.0 * 0.04 * 0.75 * 280.0 / 480.0, 2.5);
}

TEST(RollingShutter, ShowsAStandingCameraTheSame) {
  const auto world = roomOf("brick");
  const auto T = cameraBefore(1.0, 0.2);
  CameraOptics optics;
  const auto global = seen(world, T, optics);
  optics.rolling_shutter = 0.02;
  EXPECT_EQ(cv::norm(global, seen(world, T, optics), cv::NORM_INF), 0.0);
}

TEST(LightLevel, ScalesTheWholePictureBeforeItsNoise) {
  const auto world = roomOf("posters");
  const auto camera = studioCamera(world, {});
  const auto path = standing(cameraBefore(2.0, 0.0));
  const auto full = camera.render(path, RandomStream(1, 1));
  const auto half = camera.render(path, RandomStream(1, 1), 0.5);
  EXPECT_NEAR(cv::mean(half)[0] / cv::mean(full)[0], 0.5, 0.01);
  const auto none = camera.render(path, RandomStream(1, 1), 0.0);
  EXPECT_LT(cv::mean(none)[0], 3.0);
}

}  // namespace
}  // namespace slam::sim
