// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/association.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "slam_core/association/gate.hpp"
#include "slam_core/ekf/candidates.hpp"

namespace slam::ekf {

using association::Decision;

Associator::Associator(const EkfConfig& config)
    : policy_(association::makePolicy(config.association)),
      gate_(association::gateOf(config.gate_probability)),
      linearizations_(config.iterations),
      map_is_fixed_(config.mapIsFixed()) {}

Association Associator::associate(const LandmarkObservationArray& array, EkfState& state,
                                  const ObservationModel& model, Counters& counters) {
  if (policy_->usesPlaces()) {
    const auto near = landmarksByPlace(array, state, model, gate_);
    state.take(near.all());
    policy_->decide(array, PlaceCandidates(array, state, model, near), map_is_fixed_, decisions_);
  } else {
    state.take(landmarksById(array, state));
    policy_->decide(array, IdCandidates(state), map_is_fixed_, decisions_);
  }
  decisions_.resize(array.observations.size());
  Association association;
  sort(array, state, model, association, counters);
  return association;
}

void Associator::sort(const LandmarkObservationArray& array, const EkfState& state,
                      const ObservationModel& model, Association& association,
                      Counters& counters) const {
  using Kind = Decision::Kind;
  for (std::size_t i = 0; i < array.observations.size(); ++i) {
    const auto& z = array.observations[i];
    const auto landmark = decisions_[i].landmark;
    const bool is_offered = landmark < state.landmarks() && state.slotOf(landmark) >= 0;
    const auto kind = decisions_[i].checked(map_is_fixed_, is_offered);
    if (kind == Kind::kNew) {
      association.unseen.push_back(z);
    } else if (kind == Kind::kLandmark) {
      Match match{state.slotOf(landmark), z};
      match.z.id = state.id(landmark);
      if (passesGate(match, state, model, array.sensor_pose, association))
        association.matches.push_back(match);
      else
        association.gated.push_back(match.z);
    } else if (kind == Kind::kDuplicate) {
      counters.add("duplicate");
    } else {
      counters.add(kind == Kind::kNotInMap ? "not_in_map" : "unknown_id");
      ++association.unknown;
    }
  }
  counters.add("gated", association.gated.size());
}

/// Where the prediction is far off, a right observation may fail its gate for the linearisation
/// alone: the second look is iterated.
bool Associator::passesGate(const Match& match, const EkfState& state,
                            const ObservationModel& model, const Pose2& sensor,
                            Association& association) const {
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
  const bool passes = look(1) || (linearizations_ > 1 && look(linearizations_));
  if (!seen) return false;
  association.innovations.push_back(*seen);
  if (!passes)
    association.gated_log_likelihood += association::outlierLogLikelihood(gate_, nis, seen->S);
  return passes;
}

}  // namespace slam::ekf
