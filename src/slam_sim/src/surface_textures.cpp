// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/surface_textures.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "slam_core/common/random.hpp"

namespace slam::sim {
namespace {

cv::Mat toGray(const cv::Mat& values) {
  cv::Mat gray;
  values.convertTo(gray, CV_8U);  // saturates
  return gray;
}

/// Grains: each texel by itself, then as coarse as `sigma` [texels].
cv::Mat grains(int edge, double sigma, std::uint64_t seed) {
  cv::Mat noise(edge, edge, CV_32F);
  RandomStream random(seed, 0);
  for (auto it = noise.begin<float>(); it != noise.end<float>(); ++it) {
    *it = static_cast<float>(2.0 * random.uniform() - 1.0);
  }
  cv::Mat wide, blurred;
  const int rim = 16;
  cv::copyMakeBorder(noise, wide, rim, rim, rim, rim, cv::BORDER_WRAP);
  cv::GaussianBlur(wide, blurred, cv::Size(), sigma);
  return blurred(cv::Rect(rim, rim, edge, edge)).clone();
}

}  // namespace

cv::Mat plasterTexture(int edge, std::uint64_t seed) {
  const cv::Mat stains = fractalNoise(edge, 4, 4, seed);
  const cv::Mat roughness = grains(edge, 0.8, seed + 1);
  return toGray(220.0 + 6.0 * stains + 22.0 * roughness);
}

cv::Mat wallpaperTexture(int edge, std::uint64_t seed) {
  cv::Mat paper = 218.0 + 8.0 * grains(edge, 1.0, seed) + 3.0 * fractalNoise(edge, 4, 3, seed + 1);
  const int stripe = edge / 16;
  for (int x = 0; x < edge; x += 2 * stripe) {
    paper(cv::Rect(x, 0, stripe, edge)) -= 9.0;
    const int middle = x + stripe + stripe / 2;
    for (int y = (x / stripe) % 4 == 0 ? stripe : 2 * stripe; y < edge; y += 2 * stripe) {
      cv::ellipse(paper, {middle, y}, {stripe / 5, stripe / 3}, 0, 0, 360, 196.0, cv::FILLED);
      cv::circle(paper, {middle, y - stripe / 2}, stripe / 9, 202.0, cv::FILLED);
    }
  }
  return toGray(paper);
}

cv::Mat floorTexture(int edge, std::uint64_t seed) {
  cv::Mat floor =
      150.0 + 60.0 * grains(edge, 1.2, seed) + 14.0 * fractalNoise(edge, 16, 5, seed + 1);
  RandomStream random(seed + 2, 0);
  const auto pick = [&random](int n) { return static_cast<int>(random.uniform() * n); };
  const int margin = 4;
  for (int i = 0; i < edge * edge / 700; ++i) {
    const cv::Point at(margin + pick(edge - 2 * margin), margin + pick(edge - 2 * margin));
    const double gray = random.uniform() < 0.5 ? 95.0 : 205.0;
    cv::ellipse(floor, at, {1 + pick(3), 1 + pick(2)}, pick(180), 0, 360, gray, cv::FILLED);
  }
  floor.rowRange(0, 2) -= 45.0;  // where two sheets meet
  return toGray(floor);
}

cv::Mat woodTexture(int edge, std::uint64_t seed) {
  const cv::Mat coarse = fractalNoise(edge, 8, 4, seed);
  cv::Mat wood(edge, edge, CV_32F);
  for (int v = 0; v < edge; ++v) {
    // Stretched along v, there and back again, which closes the grain.
    const int row = std::min(v, edge - 1 - v) / 8;
    for (int u = 0; u < edge; ++u) wood.at<float>(v, u) = coarse.at<float>(row, 4 * u % edge);
  }
  return toGray(190.0 + 40.0 * wood + 10.0 * grains(edge, 0.8, seed + 1));
}

}  // namespace slam::sim
