// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/delayed_decisions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "slam_core/association/gate.hpp"
#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {
namespace {

/// A node is looked at again when so many others have followed.
constexpr std::array<std::size_t, 3> kAges = {10, 30, 90};

/// An observation that was ambiguous at first has to pass a stricter test later.
association::PolicyConfig laterConfig(const GraphConfig& config) {
  constexpr double kGateProbability = 0.99;
  constexpr double kAmbiguity = 2.0;  // times that of a decision at once
  association::PolicyConfig later{std::min(kGateProbability, config.gate_probability),
                                  config.places};
  later.places.ambiguity *= kAmbiguity;
  return later;
}

}  // namespace

DelayedDecisions::DelayedDecisions(const GraphConfig& config)
    : policy_(association::makePolicy(config.association, laterConfig(config))),
      map_is_fixed_(config.mapIsFixed()) {
  constexpr double kContradiction = 2.0;  // times the gate, since errors of sensors are alike
  const double gate = association::gateOf(config.gate_probability);
  contradiction_ = kContradiction * gate;
  ring_gate_ = config.places.ring * config.places.ring * gate;
}

void DelayedDecisions::keep(const LandmarkObservationArray& array, const Association& association,
                            LandmarkGraph& landmarks) {
  Waiting waiting;
  auto ambiguous = array;
  ambiguous.observations.clear();
  for (std::size_t i = 0; i < association.taken.size(); ++i) {
    if (association.taken[i].taken_for != TakenFor::kAmbiguous) continue;
    ambiguous.observations.push_back(array.observations[i]);
    waiting.readings.push_back({{array.stamp, association.taken[i].own_id}});
  }
  if (!ambiguous.observations.empty()) {
    waiting.seen = fromNode(landmarks, ambiguous);
    at(waiting.seen.node).waiting.push_back(std::move(waiting));
  }
  const auto last = lastNodeOf(landmarks);
  if (!last) return;
  for (const auto& [own_id, id, taken_for] : association.taken)
    if (const auto landmark = landmarks.ids().find(id);
        taken_for == TakenFor::kLandmark && landmark)
      at(*last).paired.push_back({{array.stamp, own_id}, *landmark});
}

DelayedDecisions::Node& DelayedDecisions::at(graph::Key key) {
  if (nodes_.empty() || nodes_.back().key != key) {
    nodes_.push_back({key, {}, {}});
    ++due_;
  }
  return nodes_.back();
}

std::vector<RevisedAssociation> DelayedDecisions::revise(
    const association::DescriptorMap& descriptors, LandmarkGraph& landmarks, Counters& counters) {
  told_.clear();
  for (; due_ > 0; --due_) {
    for (const auto age : kAges) {
      if (nodes_.size() < age + due_) continue;
      auto& node = nodes_[nodes_.size() - age - due_];
      decide(node, descriptors, landmarks);
      takeBack(node, landmarks);  // what it frees is decided on at the next age
    }
  }
  while (nodes_.size() > kAges.back()) nodes_.pop_front();
  for (const auto& told : told_)
    counters.add(told.observation.taken_for == TakenFor::kTakenBack ? "taken_back"
                                                                    : "decided_later");
  return std::exchange(told_, {});
}

/// The last sighting of a landmark stays, so that it has a place.
void DelayedDecisions::takeBack(Node& node, LandmarkGraph& landmarks) {
  for (const auto landmark : contradictionsOf(landmarks, node.key, contradiction_)) {
    if (sightingsOf(landmarks).count(landmark) < 2) continue;
    Waiting waiting{withdraw(landmarks, landmark, node.key), {{}}};
    auto& paired = node.paired;
    for (const auto& each : paired) {
      if (each.landmark != landmark) continue;
      tell(each.reading, landmarks.ids()[landmark], TakenFor::kTakenBack);
      waiting.readings[0].push_back(each.reading);
    }
    const auto is_of = [&](const Paired& each) { return each.landmark == landmark; };
    paired.erase(std::remove_if(paired.begin(), paired.end(), is_of), paired.end());
    node.waiting.push_back(std::move(waiting));
  }
}

/// Whether another observation of the same array is of the landmark.
bool DelayedDecisions::isTaken(const Node& node, const std::vector<Reading>& readings,
                               std::size_t landmark) {
  return std::any_of(node.paired.begin(), node.paired.end(), [&](const Paired& each) {
    return each.landmark == landmark &&
           std::any_of(readings.begin(), readings.end(),
                       [&](const Reading& reading) { return reading.stamp == each.reading.stamp; });
  });
}

std::vector<association::Pairing> DelayedDecisions::pairingsOf(
    const NodeObservations& seen, const association::DescriptorMap& descriptors,
    const LandmarkGraph& landmarks) const {
  using association::Decision;
  std::vector<Decision> decisions;
  policy_->decide(seen.array,
                  PlaceCandidates(seen.array, landmarks, descriptors, ring_gate_, seen.node),
                  map_is_fixed_, decisions);
  decisions.resize(seen.array.observations.size());
  std::vector<association::Pairing> pairings;
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].checked(map_is_fixed_, decisions[i].landmark < landmarks.ids().size()) ==
        Decision::Kind::kLandmark)
      pairings.push_back({i, decisions[i].landmark});
  return pairings;
}

void DelayedDecisions::decide(Node& node, const association::DescriptorMap& descriptors,
                              LandmarkGraph& landmarks) {
  for (auto& [seen, readings] : node.waiting) {
    seen = renewed(landmarks, std::move(seen));
    auto pairings = pairingsOf(seen, descriptors, landmarks);
    std::reverse(pairings.begin(), pairings.end());  // the last one is erased first
    for (const auto& [observation, landmark] : pairings) {
      if (isTaken(node, readings[observation], landmark)) continue;
      const auto i = static_cast<std::ptrdiff_t>(observation);
      landmarks.observe({landmark, seen.array.observations[observation]}, seen.array.sensor_pose,
                        node.key);
      for (const auto& reading : readings[observation]) {
        tell(reading, landmarks.ids()[landmark], TakenFor::kLandmark);
        node.paired.push_back({reading, landmark});
      }
      seen.array.observations.erase(seen.array.observations.begin() + i);
      readings.erase(readings.begin() + i);
    }
  }
  const auto is_decided = [](const Waiting& each) { return each.seen.array.observations.empty(); };
  node.waiting.erase(std::remove_if(node.waiting.begin(), node.waiting.end(), is_decided),
                     node.waiting.end());
}

void DelayedDecisions::tell(const Reading& reading, LandmarkId landmark, TakenFor taken_for) {
  told_.push_back({reading.stamp, {reading.own_id, landmark, taken_for}});
}

void DelayedDecisions::forget(graph::Key node) {
  const auto is_it = [node](const Node& each) { return each.key == node; };
  nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), is_it), nodes_.end());
}

}  // namespace slam::graph_slam
