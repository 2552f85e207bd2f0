// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::particle_filter {

void Weights::reset(std::size_t count) {
  logs_.assign(count, 0.0);
  normalized_.assign(count, 1.0 / static_cast<double>(count));
}

bool Weights::multiply(const std::vector<double>& log_factors) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    logs_[i] += log_factors[i];
    if (std::isnan(logs_[i])) logs_[i] = -std::numeric_limits<double>::infinity();
    largest = std::max(largest, logs_[i]);
  }
  if (!std::isfinite(largest)) {
    reset(size());
    return false;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    logs_[i] -= largest;  // the largest weight is 1: no step can make all of them underflow
    normalized_[i] = std::exp(logs_[i]);
    sum += normalized_[i];
  }
  for (auto& weight : normalized_) weight /= sum;
  return true;
}

double Weights::effectiveSize() const {
  double sum_of_squares = 0.0;
  for (const double weight : normalized_) sum_of_squares += weight * weight;
  return 1.0 / sum_of_squares;
}

}  // namespace slam::particle_filter
