// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/usual_fit.hpp"

#include <algorithm>

#include "slam_core/models/beta_distribution.hpp"

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

}  // namespace

double ShareDistribution::logLikelihood(const Agreement& counts) const {
  constexpr double kEndsAlike = 6.0, kMostEnds = 20.0;
  if (counts.known() == 0) return 0.0;
  const double ends = std::min(kMostEnds, counts.known() / kEndsAlike);
  const double against = ends * counts.contradicting / counts.known();
  return BetaDistribution{contradicting, agreeing}.logLikelihood(against, ends - against);
}

/// By the moments.
ShareDistribution UsualFit::distribution() const {
  const double mean = std::max(mean_, kLeastShare);
  const double variance = std::max(variance_, kLeastDeviation * kLeastDeviation);
  const auto share = BetaDistribution::ofMoments(mean, variance, kLeastPrecision, kMostPrecision);
  return {share.yes, share.no};
}

void UsualFit::learn(const Agreement& counts, double weight) {
  if (counts.known() == 0) return;
  const double off = std::min(kMostShare, counts.contradictingShare()) - mean_;
  const double gain = weight / kMemory;
  variance_ += gain * (off * off - variance_);
  mean_ += gain * off;
}

}  // namespace slam::scan_matching
