// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "slam_sim/light_map.hpp"
#include "slam_sim/surface_textures.hpp"
#include "slam_sim/texture.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {
namespace {

double step(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total());
}

/// The step from the last column to the first is no larger than the largest within.
void expectSeamless(const cv::Mat& gray, const char* name) {
  double largest = 0.0;
  for (int u = 1; u < gray.cols; ++u) {
    largest = std::max(largest, step(gray.col(u - 1), gray.col(u)));
  }
  EXPECT_LE(step(gray.col(gray.cols - 1), gray.col(0)), 1.2 * largest) << name;
}

TEST(SurfaceTextures, AreSeamlessAndNeitherBlackNorFlat) {
  const std::vector<std::pair<const char*, cv::Mat>> textures = {
      {"plaster", plasterTexture(256, 1)},
      {"wallpaper", wallpaperTexture(256, 1)},
      {"wood", woodTexture(256, 1)},
      {"ceiling", ceilingTexture("plaster", 256, 1)}};
  for (const auto& [name, gray] : textures) {
    expectSeamless(gray, name);
    expectSeamless(gray.t(), name);
    cv::Scalar mean, deviation;
    cv::meanStdDev(gray, mean, deviation);
    EXPECT_GT(mean[0], 100.0) << name;
    EXPECT_GT(deviation[0], 1.0) << name;
  }
}

TEST(SurfaceTextures, AreTheSameForTheSameSeed) {
  EXPECT_EQ(cv::norm(plasterTexture(128, 5), plasterTexture(128, 5), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(plasterTexture(128, 5), plasterTexture(128, 6), cv::NORM_INF), 0.0);
  for (const auto& name : ceilingTextures()) EXPECT_EQ(ceilingTexture(name, 256, 1).cols, 256);
  EXPECT_THROW(ceilingTexture("tile", 256, 1), std::invalid_argument);
}

TEST(Texture, KeepsItsMeanFromLevelToLevel) {
  const cv::Mat gray = plasterTexture(128, 2);
  const Texture texture(gray, Texture::Wrap::kRepeat);
  ASSERT_EQ(texture.levels().size(), 6U);
  for (std::size_t level = 0; level < texture.levels().size(); ++level) {
    const auto& stored = texture.levels()[level];
    const int edge = 128 >> level;
    double sum = 0.0;
    for (int v = 0; v < edge; ++v) {
      for (int u = 0; u < edge; ++u)
        sum += stored.texels[static_cast<std::size_t>(v * stored.stride + u)];
    }
    EXPECT_NEAR(sum / (edge * edge), texture.mean(), 0.25);
    // The rim repeats the other side.
    EXPECT_EQ(stored.texels[static_cast<std::size_t>(edge)], stored.texels[0]);
  }
}

TEST(Texture, RefusesWhatItCannotRepeat) {
  EXPECT_THROW(Texture(cv::Mat(100, 100, CV_8UC1), Texture::Wrap::kRepeat), std::invalid_argument);
  EXPECT_NO_THROW(Texture(cv::Mat(100, 100, CV_8UC1), Texture::Wrap::kClamp));
  EXPECT_THROW(Texture(cv::Mat(), Texture::Wrap::kClamp), std::invalid_argument);
  EXPECT_THROW(Texture(cv::Mat(64, 64, CV_8UC3), Texture::Wrap::kClamp), std::invalid_argument);
}

TEST(LightMap, IsTheIrradianceOfItsPlace) {
  const Lamps lamps;
  const Rectangle wall{
      {0.0, 0.0, 2.4}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ(), 5.0, 2.4};
  const LightMap map(wall, lamps);
  for (const double u : {0.3, 1.7, 4.9}) {
    for (const double v : {0.2, 1.1, 2.0}) {
      EXPECT_NEAR(map.at(u, v), irradiance(lamps, wall.at(u, v), wall.normal()), 0.03);
    }
  }
  EXPECT_EQ(map.at(-1.0, 9.0), map.at(0.0, 2.4F));
}

TEST(LightMap, IsBrighterUnderALampThanBetweenLamps) {
  const Lamps lamps;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const double under = irradiance(lamps, {lamps.first, lamps.first, 0.0}, up);
  const double between = irradiance(
      lamps, {lamps.first + lamps.spacing / 2, lamps.first + lamps.spacing / 2, 0.0}, up);
  EXPECT_GT(under, between);
  EXPECT_GT(between, 0.5);
  EXPECT_LT(under, 1.5);
}

}  // namespace
}  // namespace slam::sim
