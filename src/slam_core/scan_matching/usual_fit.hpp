// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/scan_matching/agreement.hpp"

namespace slam::scan_matching {

/// The distribution of the share of ends that contradict a map: Beta(contradicting, agreeing).
struct ShareDistribution {
  double contradicting, agreeing;

  /// Log-likelihood of a scan's counts, up to a term that is the same for all distributions. The
  /// share differs from scan to scan, so that the counts are beta-binomial (Skellam 1948).
  /// Neighbouring ends have the same errors: only as many ends are counted as have independent
  /// errors.
  double logLikelihood(const Agreement& counts) const;
};

/// How much of a scan usually contradicts the map when the robot is at its estimated pose. People,
/// glass and thin legs contradict it in every building, and in some parts more than in others. Mean
/// and spread of the share are learnt from the latest scans, beginning with values that were
/// typical of several buildings.
class UsualFit {
 public:
  ShareDistribution distribution() const;
  /// @param weight of this scan, in independent scans
  void learn(const Agreement& counts, double weight);
  double share() const { return mean_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(mean_, variance_);
  }

 private:
  double mean_ = 0.06, variance_ = 0.06 * 0.06;
};

}  // namespace slam::scan_matching
