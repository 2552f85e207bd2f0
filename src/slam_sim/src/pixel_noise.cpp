// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pixel_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace slam::sim {
namespace {

constexpr unsigned kBits = 12;
constexpr std::size_t kQuantiles = 1U << kBits;

/// The value that a standard normal variable stays below with that probability.
double normalQuantile(double probability) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2.0;
    (0.5 * std::erfc(-middle * M_SQRT1_2) < probability ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

/// Of a normal variable: mean 0, variance 1 as a discrete distribution.
std::array<float, kQuantiles> makeQuantiles() {
  std::array<double, kQuantiles> values{};
  double squares = 0.0;
  for (std::size_t i = 0; i < kQuantiles; ++i) {
    values[i] = normalQuantile((static_cast<double>(i) + 0.5) / kQuantiles);
    squares += values[i] * values[i];
  }
  std::array<float, kQuantiles> quantiles{};
  const double scale = 1.0 / std::sqrt(squares / kQuantiles);
  for (std::size_t i = 0; i < kQuantiles; ++i) quantiles[i] = static_cast<float>(scale * values[i]);
  return quantiles;
}

}  // namespace

cv::Mat withPixelNoise(const cv::Mat& gray, double sigma, RandomStream random) {
  static const std::array<float, kQuantiles> kTable = makeQuantiles();
  const auto strength = static_cast<float>(sigma);
  cv::Mat noisy(gray.size(), CV_8UC1);
  const auto width = static_cast<std::size_t>(gray.cols);
  std::vector<float> row_noise(width + 1);
  for (int v = 0; v < gray.rows; ++v) {
    for (std::size_t u = 0; u < width; u += 2) {
      const std::uint32_t bits = random.bits();
      row_noise[u] = kTable[bits >> (32 - kBits)];
      row_noise[u + 1] = kTable[bits & (kQuantiles - 1)];
    }
    const auto* in = gray.ptr<float>(v);
    auto* out = noisy.ptr<std::uint8_t>(v);
    for (std::size_t u = 0; u < width; ++u) {
      const float value = in[u] + strength * row_noise[u] + 0.5F;
      out[u] = static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F));
    }
  }
  return noisy;
}

}  // namespace slam::sim
