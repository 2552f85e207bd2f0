// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/particle_filter/proposal.hpp"
#include "slam_core/particle_filter/weights.hpp"

namespace slam::particle_filter {

/// How well the observations of a step were foreseen by all particles together, and whether they
/// have been foreseen so badly for a while that the robot must be somewhere else.
class FitMonitor {
 public:
  explicit FitMonitor(double lost_nis = 5.0) : lost_nis_(lost_nis) {}

  /// Fills in nis, nis_dof, used, gated and the innovations. An observation counts as gated when
  /// the particles of more than half of the weight gate it.
  /// @param predictions of particle 0 for all matches, then of particle 1, ...
  /// @param weights before the step
  void judge(const std::vector<Prediction>& predictions, const Sight& sight,
             std::vector<double> weights, UpdateStatistics& statistics);

  /// Whether the last observations were on average much worse than foreseen.
  bool isLost() const;
  /// A new place or map: what was seen before says nothing of it.
  void forget() { nis_ = dof_ = 0.0; }

 private:
  double lost_nis_;
  double nis_ = 0.0, dof_ = 0.0;  ///< sums in which older observations count less
};

}  // namespace slam::particle_filter
