// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/scan_matching/agreement.hpp"

namespace slam::scan_matching {

/// The distribution of the share of ends that contradict a map: Beta(contradicting, agreeing).
struct ShareDistribution {
  double contradicting, agreeing;

  /// Logarithm of the likelihood of a scan's counts, up to what is the same for all distributions.
  /// The share differs from scan to scan, so that the counts are beta-binomial (Skellam 1948).
  /// Neighbouring ends err alike: no more ends are counted than err alone.
  double logLikelihood(const Agreement& counts) const;
};

/// How much of a scan usually contradicts the map where the robot is where it takes itself to be:
/// people, glass and thin legs do in every building, and in one part more than in another. Mean and
/// spread of the share are learnt from the latest scans, beginning with what several buildings had.
class UsualFit {
 public:
  ShareDistribution distribution() const;
  /// @param weight of this scan, in independent ones
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
