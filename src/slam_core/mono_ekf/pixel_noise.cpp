// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/pixel_noise.hpp"

#include <algorithm>

namespace slam::mono_ekf {
namespace {

constexpr double kMostInformation = 1000.0;  // of some 40 images with 40 features
constexpr double kLargestLogFactor = 6.438;  // 25 times the sigma
constexpr double kLargestStep = 0.5;         // a single image may be wrong

}  // namespace

void PixelNoise::learn(const PixelScore& score) {
  information_ = std::min(information_ + score.information, kMostInformation);
  const double step = std::clamp(score.slope / information_, -kLargestStep, kLargestStep);
  log_factor_ = std::clamp(log_factor_ + step, 0.0, kLargestLogFactor);
}

void PixelNoise::doubt() {
  log_factor_ = std::max(log_factor_, kFirstLogFactor);
  information_ = kFirstInformation;
}

}  // namespace slam::mono_ekf
