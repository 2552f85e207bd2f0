// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/noise_adaptation.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

/// Less may be errors that are alike from reading to reading, which no larger sigma mends.
constexpr double kSmallestFactor = 2.5;
constexpr double kLargestScale = 30.0;
constexpr double kLargestFactor = 3.0;  ///< at once

ConsistencyMonitor::Source sourceOf(InnovationBias::Direction direction) {
  if (direction == InnovationBias::kRange) return ConsistencyMonitor::kRange;
  if (direction == InnovationBias::kBearing) return ConsistencyMonitor::kBearing;
  return ConsistencyMonitor::kMotion;
}

}  // namespace

bool NoiseAdaptation::learn(const ConsistencyMonitor& monitor, const UpdateStatistics& statistics) {
  using Fault = ConsistencyMonitor::Fault;
  if (monitor.fault() == Fault::kLost) return false;
  const bool tells_sources = statistics.joint.H.rows() > 0;
  if (monitor.fault() == Fault::kBias) {
    const auto& bias = biasOf(monitor);
    // the mean square of what is biased by b standard deviations is 1 + b^2
    return multiply(tells_sources ? sourceOf(bias.direction()) : Source::kMotion,
                    std::hypot(1.0, bias.mean().size));
  }
  const auto blamed = blamedOf(monitor);
  if (!blamed) return false;
  const double factor = monitor.factors()[*blamed].sigma;
  const auto source = tells_sources ? *blamed : Source::kMotion;
  const bool is_large = factor >= kSmallestFactor || scale(source) > 1.0;
  return is_large && multiply(source, factor);
}

bool NoiseAdaptation::multiply(Source source, double factor) {
  auto& scale = scales_[source];
  const double before = scale;
  scale = std::clamp(scale * std::clamp(factor, 1.0 / kLargestFactor, kLargestFactor), 1.0,
                     kLargestScale);
  return scale != before;
}

bool NoiseAdaptation::isNeutral() const {
  return std::all_of(scales_.begin(), scales_.end(), [](double scale) { return scale == 1.0; });
}

Motion NoiseAdaptation::scaled(const Motion& motion) const {
  if (scale(Source::kMotion) == 1.0) return motion;
  auto enlarged = motion;
  enlarged.covariance *= scale(Source::kMotion) * scale(Source::kMotion);
  return faultOf(enlarged).empty() ? enlarged : motion;
}

LandmarkObservationArray NoiseAdaptation::scaled(LandmarkObservationArray array) const {
  const Eigen::Vector2d scales(scale(Source::kRange), scale(Source::kBearing));
  for (auto& z : array.observations) {
    auto enlarged = z;
    enlarged.covariance = scales.asDiagonal() * z.covariance * scales.asDiagonal();
    if (faultOf(enlarged).empty()) z = enlarged;
  }
  return array;
}

}  // namespace slam
