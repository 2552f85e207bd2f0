// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/serial_correlation.hpp"

#include <cmath>

namespace slam {
namespace {

/// Larger innovations are cut to this, so that a few outliers do not decide [standard deviations].
constexpr double kFurthest = 5.0;

Eigen::Vector2d normalized(const ObservationInnovation& innovation) {
  const Eigen::Array2d sigma = innovation.S.diagonal().array().sqrt();
  return (innovation.nu.array() / sigma).max(-kFurthest).min(kFurthest).matrix();
}

}  // namespace

void SerialCorrelation::add(const std::vector<ObservationInnovation>& innovations) {
  if (innovations.empty()) return;
  Step step;
  std::map<LandmarkId, Eigen::Vector2d> now;
  for (const auto& innovation : innovations) {
    const Eigen::Vector2d w = now[innovation.id] = normalized(innovation);
    const auto before = previous_.find(innovation.id);
    if (before == previous_.end()) continue;
    for (std::size_t c = 0; c < kComponents; ++c) {
      const auto row = static_cast<Eigen::Index>(c);
      const double product = w(row) * before->second(row);
      step[c].products += product;
      step[c].squares += 0.5 * (w(row) * w(row) + before->second(row) * before->second(row));
    }
  }
  previous_ = std::move(now);
  steps_.push_back(step);
  if (steps_.size() > window_) steps_.pop_front();
}

double SerialCorrelation::coefficient(Component component) const {
  Sums sum;
  for (const auto& step : steps_) {
    sum.products += step[component].products;
    sum.squares += step[component].squares;
  }
  return sum.squares > 0.0 ? sum.products / sum.squares : 0.0;
}

}  // namespace slam
