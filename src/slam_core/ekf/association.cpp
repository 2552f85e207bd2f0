// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/association.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/association/gate.hpp"
#include "slam_core/ekf/candidates.hpp"

namespace slam::ekf {

using association::Decision;

Associator::Associator(const EkfConfig& config)
    : policy_(
          association::makePolicy(config.association, {config.gate_probability, config.places})),
      places_(config.places),
      gate_(association::gateOf(config.gate_probability)),
      linearizations_(config.iterations),
      map_is_fixed_(config.mapIsFixed()) {}

void Associator::restart(const LandmarkMap& map) {
  evidence_ = association::PlaceEvidence();
  if (policy_->usesPlaces()) evidence_ = association::PlaceEvidence(places_, map);
  descriptors_ = association::DescriptorMap(map);
}

Association Associator::associate(const LandmarkObservationArray& array, EkfState& state,
                                  const ObservationModel& model, Counters& counters) {
  evidence_.see(array);
  decide(array, state, model);
  decisions_.resize(array.observations.size());
  evidence_.hold(array, decisions_);
  Association association;
  sort(array, state, model, association, counters);
  if (!map_is_fixed_)
    for (const auto& match : association.matches) descriptors_.see(match.z.id, match.z.descriptor);
  return association;
}

void Associator::decide(const LandmarkObservationArray& array, EkfState& state,
                        const ObservationModel& model) {
  if (!policy_->usesPlaces()) {
    state.take(landmarksById(array, state));
    policy_->decide(array, IdCandidates(state), map_is_fixed_, decisions_);
    return;
  }
  const auto near = landmarksByPlace(array, state, model, places_.ring * places_.ring * gate_);
  state.take(near.all());
  policy_->decide(array, PlaceCandidates(array, state, model, near, descriptors_), map_is_fixed_,
                  decisions_);
}

std::vector<Decision::Kind> Associator::checked(const EkfState& state) const {
  std::vector<Decision::Kind> kinds;
  for (const auto& decision : decisions_) {
    const auto landmark = decision.landmark;
    const bool is_offered = landmark < state.landmarks() && state.slotOf(landmark) >= 0;
    kinds.push_back(decision.checked(map_is_fixed_, is_offered));
  }
  return kinds;
}

void Associator::sort(const LandmarkObservationArray& array, const EkfState& state,
                      const ObservationModel& model, Association& association,
                      Counters& counters) const {
  using Kind = Decision::Kind;
  const auto kinds = checked(state);
  if (policy_->usesPlaces()) association.taken = association::recordOf(array, kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == Kind::kNew) {
      association.unseen.push_back(array.observations[i]);
      if (policy_->usesPlaces()) association.unseen.back().id = kUnknownId;
    } else if (kinds[i] == Kind::kLandmark) {
      match(i, array, state, model, association);
    } else {
      counters.add(association::reasonOf(kinds[i]));
      association.unknown += kinds[i] == Kind::kDuplicate ? 0 : 1;
    }
  }
  counters.add("gated", association.gated.size());
}

void Associator::match(std::size_t observation, const LandmarkObservationArray& array,
                       const EkfState& state, const ObservationModel& model,
                       Association& association) const {
  const auto landmark = decisions_[observation].landmark;
  Match match{state.slotOf(landmark), array.observations[observation]};
  match.z.id = state.id(landmark);
  const bool passes = passesGate(match, state, model, array.sensor_pose, association);
  if (passes)
    association.matches.push_back(match);
  else
    association.gated.push_back(match.z);
  if (association.taken.empty()) return;
  association.taken[observation].landmark = match.z.id;
  if (!passes) association.taken[observation].taken_for = TakenFor::kGated;
}

std::vector<LandmarkId> Associator::ghosts(const Association& association, const EkfState& state,
                                           const Pose2& sensor) {
  if (!policy_->usesPlaces() || map_is_fixed_) return {};
  std::vector<LandmarkId> seen;
  for (const auto& match : association.matches) seen.push_back(match.z.id);
  return evidence_.ghosts(state.robot() * sensor, state.places(), seen);
}

/// Where the prediction is far off, a right observation may fail its gate for the linearisation
/// alone: the second look is iterated.
bool Associator::passesGate(const Match& match, const EkfState& state,
                            const ObservationModel& model, const Pose2& sensor,
                            Association& association) const {
  const auto point = state.point(match.slot);
  const auto& of_kind = point.modelOr(model);
  if (match.z.isLine() != (point.line != nullptr)) return false;
  if (of_kind.isSingular(of_kind.predict(state.robot(), sensor, point.now))) return false;
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
