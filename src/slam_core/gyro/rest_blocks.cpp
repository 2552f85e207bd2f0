// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/rest_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam::gyro {
namespace {

constexpr double kBlock = 0.25;         // [s]
constexpr double kSameRate = 0.02;      // of two blocks, at least [rad/s]
constexpr double kSameDeviation = 6.0;  // or as far as noise goes [standard deviations]

bool isSame(const RestRate& a, const RestRate& b, double noise) {
  const double sigma = std::sqrt(noise * (1.0 / a.seconds + 1.0 / b.seconds));
  return std::abs(a.rate() - b.rate()) <= std::max(kSameRate, kSameDeviation * sigma);
}

}  // namespace

std::optional<RestRate> RestBlocks::add(double angle, double seconds, GyroNoise& noise) {
  current_.angle += angle;
  current_.seconds += seconds;
  if (current_.seconds < kBlock) return std::nullopt;
  const auto block = std::exchange(current_, {});
  const auto before = std::exchange(last_, block);
  if (!before || !isSame(*before, block, noise.variance())) return std::nullopt;
  noise.add(block.rate() - before->rate(), before->seconds, block.seconds);
  return before;
}

}  // namespace slam::gyro
