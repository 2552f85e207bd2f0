// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/innovation_score.hpp"

#include <Eigen/LU>
#include <cmath>

#include "slam_core/association/gate.hpp"

namespace slam::tuning {
namespace {

constexpr double kOutOfView = 5.0;  ///< [s] from sighting to sighting

/// Normal but for its tails, whatever the filter's own gate is.
double logDensity(const ObservationInnovation& z) {
  constexpr double kGate = 13.8;  // one of a thousand lies outside
  const double nis = z.nu.dot(z.S.inverse() * z.nu);
  if (nis > kGate) return association::outlierLogLikelihood(kGate, nis, z.S);
  return -0.5 * nis - std::log(2.0 * M_PI) - 0.5 * std::log(z.S.determinant());
}

}  // namespace

void Resightings::add(const LandmarkObservationArray& array) {
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) continue;
    const auto [known, is_new] = last_.emplace(z.id, array.stamp);
    if (!is_new && seconds(array.stamp - known->second) > kOutOfView)
      found_.emplace(array.stamp, z.id);
    known->second = array.stamp;
  }
}

double InnovationScore::of(const StepReport& report) {
  const auto& statistics = report.statistics;
  if (only_ == nullptr) {
    innovations_ += static_cast<int>(statistics.innovations.size());
    return statistics.log_likelihood;
  }
  double sum = 0.0;
  for (const auto& z : statistics.innovations) {
    if (!only_->has(report.stamp, z.id)) continue;
    sum += logDensity(z);
    ++innovations_;
  }
  return sum;
}

}  // namespace slam::tuning
