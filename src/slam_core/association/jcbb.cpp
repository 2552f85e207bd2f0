// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/jcbb.hpp"

#include "slam_core/association/gate.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::association {
namespace {

const Registrar<AssociationPolicy, Jcbb> kJcbbRegistrar("jcbb");

}  // namespace

void Jcbb::configure(const PolicyConfig& config) {
  gate_ = gateOf(config.gate_probability);
  places_ = config.places;
  search_.configure(config.gate_probability, places_.ambiguity, places_.nodes);
  rivals_.configure(config.gate_probability, places_.ambiguity);
}

void Jcbb::decide(const LandmarkObservationArray& array, const CandidateSource& source,
                  bool map_is_fixed, std::vector<Decision>& decisions) {
  options_.gather(array, source, gate_, places_.ring);
  decisions.clear();
  taken_.clear();
  group_.clear();
  for (std::size_t i = 0; i < options_.size(); ++i)
    decisions.push_back(options_.unpaired(i, map_is_fixed));
  for (std::size_t i = 0; i < options_.size(); ++i) {
    if (options_.of(i).empty()) continue;
    group_.push_back(i);
    if (group_.size() == JointSearch::kMostObservations) pairGroup(array, source, decisions);
  }
  pairGroup(array, source, decisions);
}

void Jcbb::pairGroup(const LandmarkObservationArray& array, const CandidateSource& source,
                     std::vector<Decision>& decisions) {
  if (group_.empty()) return;
  choices_ = search_.search(group_, options_, source, taken_);
  rivals_.judge(array, options_, source, choices_);
  for (const auto& [observation, option, is_ambiguous] : choices_) {
    if (option < 0) continue;
    const auto landmark = options_.of(observation)[static_cast<std::size_t>(option)].landmark;
    taken_.push_back(landmark);
    if (!is_ambiguous) decisions[observation] = {Decision::Kind::kLandmark, landmark};
  }
  group_.clear();
}

}  // namespace slam::association
