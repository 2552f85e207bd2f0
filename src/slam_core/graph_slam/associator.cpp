// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/associator.hpp"

#include "slam_core/association/gate.hpp"
#include "slam_core/graph_slam/candidates.hpp"
#include "slam_core/graph_slam/prediction.hpp"

namespace slam::graph_slam {

using association::Decision;

Associator::Associator(const GraphConfig& config)
    : policy_(association::makePolicy(config.association)),
      gate_(association::gateOf(config.gate_probability)),
      map_is_fixed_(config.mapIsFixed()) {}

Association Associator::associate(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                                  UpdateStatistics& statistics, Counters& counters) {
  decide(array, graph);
  Association association;
  const auto known = sort(array, graph, association, statistics, counters);
  gate(known, array.sensor_pose, graph, association, statistics);
  statistics.gated = static_cast<int>(association.gated.size());
  counters.add("gated", association.gated.size());
  return association;
}

void Associator::decide(const LandmarkObservationArray& array, const LandmarkGraph& graph) {
  if (policy_->usesPlaces())
    policy_->decide(array, PlaceCandidates(array, graph, gate_), map_is_fixed_, decisions_);
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
  for (std::size_t i = 0; i < array.observations.size(); ++i) {
    const auto landmark = decisions_[i].landmark;
    const auto kind = decisions_[i].checked(map_is_fixed_, landmark < graph.ids().size());
    if (kind == Kind::kNew) {
      association.unseen.push_back(array.observations[i]);
    } else if (kind == Kind::kLandmark) {
      known.push_back({landmark, array.observations[i]});
      known.back().z.id = graph.ids()[landmark];
    } else if (kind == Kind::kDuplicate) {
      counters.add("duplicate");
    } else {
      counters.add(kind == Kind::kNotInMap ? "not_in_map" : "unknown_id");
      ++statistics.unknown;
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
    if (prediction.isSingular(i)) {
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

}  // namespace slam::graph_slam
