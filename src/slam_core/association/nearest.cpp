// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/nearest.hpp"

#include <algorithm>
#include <tuple>

#include "slam_core/association/gate.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::association {
namespace {

const Registrar<AssociationPolicy, Nearest> kNearestRegistrar("nearest");

}  // namespace

void Nearest::configure(const PolicyConfig& config) {
  gate_ = gateOf(config.gate_probability);
  places_ = config.places;
}

void Nearest::decide(const LandmarkObservationArray& array, const CandidateSource& source,
                     bool map_is_fixed, std::vector<Decision>& decisions) {
  options_.gather(array, source, gate_, places_.ring);
  decisions.clear();
  for (std::size_t i = 0; i < options_.size(); ++i)
    decisions.push_back(options_.unpaired(i, map_is_fixed));
  collectClaims();
  grant(decisions);
}

/// An observation claims the landmark that it is most likely of, and those that are nearly as
/// likely.
void Nearest::collectClaims() {
  claims_.clear();
  for (std::size_t i = 0; i < options_.size(); ++i)
    for (const auto& option : options_.of(i))
      if (option.cost <= options_.of(i).front().cost + places_.ambiguity)
        claims_.push_back({option.landmark, option.cost, i});
  std::sort(claims_.begin(), claims_.end(), [](const Claim& a, const Claim& b) {
    return std::tie(a.landmark, a.cost, a.observation) <
           std::tie(b.landmark, b.cost, b.observation);
  });
}

void Nearest::grant(std::vector<Decision>& decisions) const {
  for (auto claim = claims_.begin(); claim != claims_.end();) {
    const auto landmark = claim->landmark;
    const auto rival = claim + 1;
    const bool is_contested = rival != claims_.end() && rival->landmark == landmark &&
                              rival->cost < claim->cost + places_.ambiguity;
    if (!is_contested && !options_.isAmbiguous(claim->observation, places_.ambiguity))
      decisions[claim->observation] = {Decision::Kind::kLandmark, landmark};
    claim = std::find_if(rival, claims_.end(),
                         [landmark](const Claim& other) { return other.landmark != landmark; });
  }
}

}  // namespace slam::association
