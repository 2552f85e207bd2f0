// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/ekf/ekf_state.hpp"
#include "slam_core/ekf/linearization.hpp"

namespace slam::ekf {

/// What the observations of one stamp are to the map.
struct Association {
  std::vector<Innovation> innovations;      ///< of known landmarks, within the gate
  std::vector<LandmarkObservation> unseen;  ///< of landmarks that are not in the map yet
  int gated = 0;
  int unknown = 0;  ///< without an id
};

/// Association by the observations' own ids. A known landmark's observation must pass the
/// chi-square gate on its own; of two observations of one id the first counts ("duplicate").
class KnownIdAssociation {
 public:
  explicit KnownIdAssociation(double gate_probability = 0.9999);

  Association associate(const LandmarkObservationArray& array, const EkfState& state,
                        const ObservationModel& model, const Linearization& linearization,
                        Counters& counters) const;

 private:
  bool passesGate(const Innovation& innovation, const DenseCovariance& P) const;

  double gate_;  ///< largest squared Mahalanobis distance
};

}  // namespace slam::ekf
