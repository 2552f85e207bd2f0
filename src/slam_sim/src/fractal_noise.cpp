// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

/// Random values on a lattice that closes on itself.
std::vector<float> lattice(int cells, RandomStream random) {
  std::vector<float> values(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
  for (float& value : values) value = static_cast<float>(2.0 * random.uniform() - 1.0);
  return values;
}

/// The two cells beside each texel, and the smooth weight of the second.
struct Position {
  std::size_t low, high;
  float weight;
};

std::vector<Position> positions(int edge, int cells) {
  std::vector<Position> all(static_cast<std::size_t>(edge));
  const auto n = static_cast<std::size_t>(cells);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) * cells / edge;
    const double part = x - std::floor(x);
    const auto low = static_cast<std::size_t>(x);
    all[i] = {low % n, (low + 1) % n, static_cast<float>(part * part * (3.0 - 2.0 * part))};
  }
  return all;
}

void addOctave(cv::Mat& sum, int cells, float amplitude, RandomStream random) {
  const auto values = lattice(cells, random);
  const auto at = positions(sum.cols, cells);
  const auto n = static_cast<std::size_t>(cells);
  for (int v = 0; v < sum.rows; ++v) {
    const Position& row = at[static_cast<std::size_t>(v)];
    const float* upper = &values[row.low * n];
    const float* lower = &values[row.high * n];
    auto* out = sum.ptr<float>(v);
    for (const Position& column : at) {
      const float left = upper[column.low] + row.weight * (lower[column.low] - upper[column.low]);
      const float right =
          upper[column.high] + row.weight * (lower[column.high] - upper[column.high]);
      *out++ += amplitude * (left + column.weight * (right - left));
    }
  }
}

}  // namespace

cv::Mat fractalNoise(int edge, int cells, int octaves, std::uint64_t seed) {
  cv::Mat sum = cv::Mat::zeros(edge, edge, CV_32F);
  float amplitude = 0.5F;
  for (int octave = 0; octave < octaves && cells <= edge; ++octave) {
    addOctave(sum, cells, amplitude, RandomStream(seed, static_cast<std::uint64_t>(octave)));
    cells *= 2;
    amplitude *= 0.5F;
  }
  return sum;
}

}  // namespace slam::sim
