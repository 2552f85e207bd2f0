// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/association.hpp"

#include <Eigen/LU>
#include <cmath>
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

/// Where the prediction is far off, a right observation may fail its gate for the linearisation
/// alone: the second look is iterated.
bool KnownIdAssociation::passesGate(const Match& match, const EkfState& state,
                                    const ObservationModel& model, const Pose2& sensor,
                                    int linearizations, Association& association) const {
  const auto predicted = model.predict(state.robot(), sensor, state.point(match.slot).now);
  if (model.isSingular(predicted)) return false;
  const std::vector<Match> one = {match};
  const auto look = [&](int limit) {
    const ObservationUpdate update(model, state, sensor, one, limit);
    if (!update.isSolved()) return false;
    const bool passes = update.nis() <= gate_;
    association.innovations.push_back(
        {match.z.id, update.innovation(0), update.covariance(0), match.z.covariance, passes});
    return passes;
  };
  const auto before = association.innovations.size();
  if (look(1)) return true;
  if (linearizations > 1) {
    association.innovations.resize(before);
    if (look(linearizations)) return true;
  }
  if (association.innovations.size() > before)
    association.gated_log_likelihood -=
        0.5 * (gate_ + 2.0 * std::log(2.0 * M_PI) +
               std::log(association.innovations.back().S.determinant()));
  return false;
}

}  // namespace slam::ekf
