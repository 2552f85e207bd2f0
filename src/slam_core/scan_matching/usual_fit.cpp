// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/usual_fit.hpp"

#include <algorithm>
#include <cmath>

namespace slam::scan_matching {
namespace {

/// A cleaner building does not make it surer: people may come.
constexpr double kLeastShare = 0.02, kLeastDeviation = 0.02;
/// A scan with more than this is none to learn from as it stands.
constexpr double kMostShare = 0.4;
/// As many independent scans are remembered: a part of a building may differ from the last one,
/// while a wrong place differs from one scan to the next.
constexpr double kMemory = 20.0;
/// A share that hardly varies is not believed, one that is anything at all neither.
constexpr double kLeastPrecision = 4.0, kMostPrecision = 60.0;

double logBeta(double a, double b) { return std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b); }

}  // namespace

double ShareDistribution::logLikelihood(const Agreement& counts) const {
  constexpr double kEndsAlike = 6.0, kMostEnds = 20.0;
  if (counts.known() == 0) return 0.0;
  const double ends = std::min(kMostEnds, counts.known() / kEndsAlike);
  const double against = ends * counts.contradicting / counts.known();
  return logBeta(contradicting + against, agreeing + ends - against) -
         logBeta(contradicting, agreeing);
}

/// By the moments.
ShareDistribution UsualFit::distribution() const {
  const double mean = std::max(mean_, kLeastShare);
  const double variance = std::max(variance_, kLeastDeviation * kLeastDeviation);
  const double precision =
      std::clamp(mean * (1.0 - mean) / variance - 1.0, kLeastPrecision, kMostPrecision);
  return {mean * precision, (1.0 - mean) * precision};
}

void UsualFit::learn(const Agreement& counts, double weight) {
  if (counts.known() == 0) return;
  const double off = std::min(kMostShare, counts.contradictingShare()) - mean_;
  const double gain = weight / kMemory;
  variance_ += gain * (off * off - variance_);
  mean_ += gain * off;
}

}  // namespace slam::scan_matching
