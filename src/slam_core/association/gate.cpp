// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/gate.hpp"

#include <Eigen/LU>
#include <cmath>

namespace slam::association {
namespace {

/// The chi-square distribution's share beyond `squared`: a Poisson sum where the degrees of freedom
/// are even (Abramowitz, Stegun 1964, 26.4.5).
double shareBeyond(double squared, std::size_t observations) {
  double term = std::exp(-0.5 * squared), sum = 0.0;
  for (std::size_t i = 0; i < observations; term *= 0.5 * squared / static_cast<double>(++i))
    sum += term;
  return sum;
}

}  // namespace

double gateOf(double probability) { return -2.0 * std::log(1.0 - probability); }

double jointGateOf(double probability, std::size_t observations) {
  if (observations == 1) return gateOf(probability);
  constexpr int kHalvings = 60;
  double low = 0.0, high = static_cast<double>(observations) * gateOf(probability);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (shareBeyond(middle, observations) > 1.0 - probability ? low : high) = middle;
  }
  return high;
}

double outlierLogLikelihood(double gate, double nis, const Eigen::Matrix2d& S) {
  return -0.5 * gate - (1.0 + 0.5 * gate) * std::log(nis / gate) - std::log(2.0 * M_PI) -
         0.5 * std::log(S.determinant());
}

}  // namespace slam::association
