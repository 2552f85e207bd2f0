// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/known_ids.hpp"

#include <algorithm>
#include <numeric>

#include "slam_core/contract/registry.hpp"

namespace slam::association {
namespace {

const Registrar<AssociationPolicy, KnownIds> kRegistrar("known_ids");

}  // namespace

void KnownIds::findRepeated(const std::vector<LandmarkObservation>& observations) {
  order_.resize(observations.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const auto isBefore = [&](std::size_t a, std::size_t b) {
    const auto &first = observations[a].id, &second = observations[b].id;
    return first != second ? first < second : a < b;
  };
  if (!std::is_sorted(order_.begin(), order_.end(), isBefore))
    std::sort(order_.begin(), order_.end(), isBefore);
  is_repeated_.assign(observations.size(), 0);
  for (std::size_t i = 1; i < order_.size(); ++i)
    is_repeated_[order_[i]] = observations[order_[i]].id == observations[order_[i - 1]].id;
}

void KnownIds::decide(const LandmarkObservationArray& array, const CandidateSource& source,
                      bool map_is_fixed, std::vector<Decision>& decisions) {
  using Kind = Decision::Kind;
  const auto& observations = array.observations;
  findRepeated(observations);
  decisions.assign(observations.size(), Decision());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    auto& decision = decisions[i];
    if (observations[i].id == kUnknownId) continue;
    if (is_repeated_[i]) {
      decision.kind = Kind::kDuplicate;
    } else if (const auto landmark = source.find(observations[i].id)) {
      decision = {Kind::kLandmark, *landmark};
    } else {
      decision.kind = map_is_fixed ? Kind::kNotInMap : Kind::kNew;
    }
  }
}

}  // namespace slam::association
