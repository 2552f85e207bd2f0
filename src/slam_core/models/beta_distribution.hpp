// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

namespace slam {

/// Describes a share that differs from one case to the next: it is distributed as Beta(yes, no).
struct BetaDistribution {
  double yes = 1.0, no = 1.0;

  /// The result has this mean and variance, as far as the bounds `least` and `most` of yes + no
  /// allow. The share varies less if yes + no is larger.
  static BetaDistribution ofMoments(double mean, double variance, double least, double most) {
    const double precision = std::clamp(mean * (1.0 - mean) / variance - 1.0, least, most);
    return {mean * precision, (1.0 - mean) * precision};
  }

  /// Logarithm of the likelihood of counts, up to what is the same for all distributions: they are
  /// beta-binomial (Skellam 1948). @param yes_count, no_count need not be whole numbers
  double logLikelihood(double yes_count, double no_count) const {
    return logBeta(yes + yes_count, no + no_count) - logBeta(yes, no);
  }

 private:
  static double logBeta(double a, double b) {
    return std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
  }
};

}  // namespace slam
