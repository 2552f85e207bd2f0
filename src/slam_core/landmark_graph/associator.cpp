// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/associator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/association/gate.hpp"
#include "slam_core/landmark_graph/candidates.hpp"
#include "slam_core/landmark_graph/prediction.hpp"

namespace slam::landmark_graph {
namespace {

/// When this many observations at once are gated and none fits, they are no chance outliers.
constexpr std::size_t kLost = 3;

}  // namespace

using association::Decision;

Associator::Associator(const AssociationConfig& config)
    : policy_(association::makePolicy(config.policy, {config.gate_probability, config.places})),
      places_(config.places),
      gate_(association::gateOf(config.gate_probability)),
      map_is_fixed_(config.map_is_fixed) {}

void Associator::restart(const LandmarkMap& map) {
  evidence_ = association::PlaceEvidence();
  if (policy_->usesPlaces()) evidence_ = association::PlaceEvidence(places_, map);
  descriptors_ = association::DescriptorMap(map);
}

Association Associator::associate(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                                  UpdateStatistics& statistics, Counters& counters) {
  evidence_.see(array);
  decide(array, graph);
  evidence_.hold(array, decisions_);
  Association association;
  const auto known = sort(array, graph, association, statistics, counters);
  gate(known, array.sensor_pose, graph, association, statistics);
  if (!map_is_fixed_)
    for (const auto& match : association.matches) descriptors_.see(match.z.id, match.z.descriptor);
  statistics.gated = static_cast<int>(association.gated.size());
  counters.add("gated", association.gated.size());
  if (policy_->usesPlaces()) recordMatches(graph, association);
  return association;
}

/// Which landmark each observation was taken for.
void Associator::recordMatches(const LandmarkGraph& graph, Association& association) const {
  const auto is_of = [](std::size_t landmark) {
    return [landmark](const Match& match) { return match.landmark == landmark; };
  };
  const auto& gated = association.gated;
  for (std::size_t i = 0; i < association.taken.size(); ++i) {
    if (association.taken[i].taken_for != TakenFor::kLandmark) continue;
    const auto landmark = decisions_[i].landmark;
    association.taken[i].landmark = graph.ids()[landmark];
    if (std::any_of(gated.begin(), gated.end(), is_of(landmark)))
      association.taken[i].taken_for = TakenFor::kGated;
  }
}

std::vector<LandmarkId> Associator::ghosts(const Association& association,
                                           const LandmarkGraph& graph, const Pose2& sensor) {
  if (!policy_->usesPlaces() || map_is_fixed_) return {};
  std::vector<LandmarkId> seen;
  for (const auto& match : association.matches) seen.push_back(match.z.id);
  std::vector<association::LandmarkPlace> places;
  for (const auto number : graph.ids().order())
    places.push_back({graph.ids()[number], graph.point(number)});
  return evidence_.ghosts(graph.robot().pose * sensor, places, seen);
}

void Associator::decide(const LandmarkObservationArray& array, const LandmarkGraph& graph) {
  if (policy_->usesPlaces())
    policy_->decide(
        array, PlaceCandidates(array, graph, descriptors_, places_.ring * places_.ring * gate_),
        map_is_fixed_, decisions_);
  else
    policy_->decide(array, IdCandidates(graph), map_is_fixed_, decisions_);
  decisions_.resize(array.observations.size());
}

/// @return the observations of known landmarks
std::vector<Match> Associator::sort(const LandmarkObservationArray& array,
                                    const LandmarkGraph& graph, Association& association,
                                    UpdateStatistics& statistics, Counters& counters) const {
  using Kind = Decision::Kind;
  std::vector<Match> known;
  std::vector<Kind> kinds;
  for (const auto& decision : decisions_)
    kinds.push_back(decision.checked(map_is_fixed_, decision.landmark < graph.ids().size()));
  if (policy_->usesPlaces()) association.taken = association::recordOf(array, kinds);
  for (std::size_t i = 0; i < array.observations.size(); ++i) {
    const auto landmark = decisions_[i].landmark;
    if (kinds[i] == Kind::kNew) {
      association.unseen.push_back(array.observations[i]);
      if (policy_->usesPlaces()) association.unseen.back().id = kUnknownId;
    } else if (kinds[i] == Kind::kLandmark) {
      known.push_back({landmark, array.observations[i]});
      known.back().z.id = graph.ids()[landmark];
    } else {
      counters.add(association::reasonOf(kinds[i]));
      statistics.unknown += kinds[i] == Kind::kDuplicate ? 0 : 1;
    }
  }
  return known;
}

/// Where the prediction is far off, a right observation may fail its gate for the linearisation
/// alone: the second look is iterated.
void Associator::gate(const std::vector<Match>& known, const Pose2& sensor,
                      const LandmarkGraph& graph, Association& association,
                      UpdateStatistics& statistics) const {
  constexpr int kLinearizations = 5;
  if (known.empty()) return;
  const Prediction prediction(graph, sensor, known);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < known.size(); ++i) {
    // rounding leaves no covariance of a landmark that is 1e9 m away
    if (prediction.isSingular(i) || prediction.covariance(i).llt().info() != Eigen::Success) {
      association.gated.push_back(known[i]);
      continue;
    }
    const double nis = prediction.nis(i, 1);
    const bool passes = nis <= gate_ || prediction.nis(i, kLinearizations) <= gate_;
    const auto S = prediction.covariance(i);
    statistics.innovations.push_back(
        {known[i].z.id, prediction.innovation(i), S, known[i].z.covariance, passes});
    if (passes) {
      used.push_back(i);
      association.matches.push_back(known[i]);
    } else {
      association.gated.push_back(known[i]);
      statistics.log_likelihood += association::outlierLogLikelihood(gate_, nis, S);
    }
  }
  if (!used.empty()) association.is_solved = prediction.summarize(used, statistics);
}

Status statusOf(const Association& association, const PathGraph& path,
                const LandmarkGraph& landmarks, bool needs_map) {
  if (association.matches.empty() && association.gated.size() >= kLost)
    return Status::alarm("no observation fits the map, all are gated: the pose may be lost");
  if (needs_map && landmarks.ids().inMap() == 0)
    return Status::warning("there is no map to localise in; load one");
  if (!association.is_solved)
    return Status::error("the innovations' covariance is not positive definite; update left out");
  if (path.graph().cost().undetermined > 0)
    return Status::warning(
        "the graph does not determine all poses and landmarks, which are held where they are: are "
        "there covariances that differ by too many orders of magnitude?");
  return Status::ok();
}

std::vector<association::Sightings::Verdict> judged(association::Sightings& sightings,
                                                    const Association& association) {
  std::vector<LandmarkId> fitting;
  for (const auto& match : association.matches) fitting.push_back(match.z.id);
  std::vector<LandmarkObservation> gated;
  for (const auto& match : association.gated) gated.push_back(match.z);
  return sightings.judge(fitting, gated);
}

}  // namespace slam::landmark_graph
