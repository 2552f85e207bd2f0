// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/association.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <set>

namespace slam::ekf {

/// The quantile of the chi-square distribution with two degrees of freedom has a closed form.
KnownIdAssociation::KnownIdAssociation(double gate_probability)
    : gate_(-2.0 * std::log(1.0 - gate_probability)) {}

Association KnownIdAssociation::associate(const LandmarkObservationArray& array,
                                          const EkfState& state, const ObservationModel& model,
                                          int linearizations, Counters& counters) const {
  Association association;
  std::set<LandmarkId> seen;
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) {
      ++association.unknown;
      continue;
    }
    if (!seen.insert(z.id).second) {
      counters.add("duplicate");
      continue;
    }
    const auto slot = state.slot(z.id);
    if (!slot) {
      association.unseen.push_back(z);
      continue;
    }
    const Match match{*slot, z};
    if (passesGate(match, state, model, array.sensor_pose, linearizations, association))
      association.matches.push_back(match);
    else
      association.gated.push_back(z);
  }
  counters.add("gated", association.gated.size());
  counters.add("unknown_id", static_cast<std::uint64_t>(association.unknown));
  return association;
}

double outlierLogLikelihood(double gate, double nis, const Eigen::Matrix2d& S) {
  return -0.5 * gate - (1.0 + 0.5 * gate) * std::log(nis / gate) - std::log(2.0 * M_PI) -
         0.5 * std::log(S.determinant());
}

/// Where the prediction is far off, a right observation may fail its gate for the linearisation
/// alone: the second look is iterated.
bool KnownIdAssociation::passesGate(const Match& match, const EkfState& state,
                                    const ObservationModel& model, const Pose2& sensor,
                                    int linearizations, Association& association) const {
  const auto predicted = model.predict(state.robot(), sensor, state.point(match.slot).now);
  if (model.isSingular(predicted)) return false;
  const std::vector<Match> one = {match};
  std::optional<ObservationInnovation> seen;
  double nis = 0.0;
  const auto look = [&](int limit) {
    const ObservationUpdate update(model, state, sensor, one, limit);
    if (!update.isSolved()) return false;
    nis = update.nis();
    seen = {match.z.id, update.innovation(0), update.covariance(0), match.z.covariance,
            nis <= gate_};
    return seen->used;
  };
  const bool passes = look(1) || (linearizations > 1 && look(linearizations));
  if (!seen) return false;
  association.innovations.push_back(*seen);
  if (!passes) association.gated_log_likelihood += outlierLogLikelihood(gate_, nis, seen->S);
  return passes;
}

}  // namespace slam::ekf
