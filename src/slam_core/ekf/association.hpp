// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/ekf/observation_update.hpp"

namespace slam::ekf {

/// What the observations of one stamp are to the map.
struct Association {
  std::vector<Match> matches;                      ///< of known landmarks, within the gate
  std::vector<LandmarkObservation> unseen;         ///< of landmarks that are not in the map yet
  std::vector<LandmarkObservation> gated;          ///< of known landmarks, outside the gate
  std::vector<ObservationInnovation> innovations;  ///< of known landmarks, gated ones included
  double gated_log_likelihood = 0.0;               ///< of the gated ones
  int unknown = 0;                                 ///< without an id
};

/// The logarithm of the density of an innovation outside the gate, from its squared Mahalanobis
/// distance: N(nu; 0, S) at the gate, and from there it falls like a power that keeps the normal
/// distribution's share of all innovations outside. So it is a density with any gate, the values
/// of S that are most likely do not depend on the gate, and an outlier costs more the smaller S is.
double outlierLogLikelihood(double gate, double nis, const Eigen::Matrix2d& S);

/// Association by the observations' own ids. A known landmark's observation must pass the
/// chi-square gate on its own; of two observations of one id the first counts ("duplicate").
class KnownIdAssociation {
 public:
  explicit KnownIdAssociation(double gate_probability = 0.9999);

  /// The known landmarks must be in the neighbourhood.
  /// @param linearizations of an observation before it is gated, see ObservationUpdate
  Association associate(const LandmarkObservationArray& array, const EkfState& state,
                        const ObservationModel& model, int linearizations,
                        Counters& counters) const;

 private:
  bool passesGate(const Match& match, const EkfState& state, const ObservationModel& model,
                  const Pose2& sensor, int linearizations, Association& association) const;

  double gate_;  ///< largest squared Mahalanobis distance
};

}  // namespace slam::ekf
