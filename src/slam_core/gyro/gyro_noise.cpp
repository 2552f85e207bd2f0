// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_noise.hpp"

#include <algorithm>

namespace slam::gyro {
namespace {

constexpr double kWeightOfFile = 4.0;
constexpr double kMostWeight = 400.0;  // then old differences fade
/// The noise is at least this share of the robot file's: a gyro that rounds to coarse steps has
/// noise as well.
constexpr double kLeastShare = 1e-4;

}  // namespace

GyroNoise::GyroNoise(double density)
    : sum_(kWeightOfFile * density * density),
      weight_(kWeightOfFile),
      least_(kLeastShare * density * density) {}

void GyroNoise::add(double difference, double seconds_before, double seconds_after) {
  const double variance = difference * difference / (1.0 / seconds_before + 1.0 / seconds_after);
  sum_ += std::max(least_, variance);
  weight_ += 1.0;
  if (weight_ <= kMostWeight) return;
  sum_ *= kMostWeight / weight_;
  weight_ = kMostWeight;
}

}  // namespace slam::gyro
