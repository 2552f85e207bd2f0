// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/associator.hpp"

#include "slam_core/particle_filter/landmarks/particle_candidates.hpp"

namespace slam::particle_filter {

using association::Decision;

Associator::Associator(const Config& config) : config_(config) {
  do {
    lanes_.push_back({association::makePolicy(config.policy, config.of_policy), {}});
  } while (asksEach() && lanes_.size() < config.lanes);
  restart({});
}

void Associator::restart(const LandmarkMap& map) {
  evidence_ = association::PlaceEvidence();
  if (asksEach()) evidence_ = association::PlaceEvidence(config_.of_policy.places, map);
  descriptors_ = association::DescriptorMap(map);
}

Association Associator::forAll(const LandmarkObservationArray& array, const LandmarkIndex& index) {
  Association association{{ask(array, IdCandidates(index), 0)}, {}};
  for (auto& match : association.sights.front().matches) {
    match.column = association.seen.size();
    association.seen.push_back(match.z);
  }
  return association;
}

/// An observation that none of the particles knows has a column as well, which says the same of all
/// of them.
Association Associator::forEach(const LandmarkObservationArray& array, const LandmarkIndex& index,
                                const ObservationModel& model, const ParticleSet& particles,
                                const std::vector<PoseGaussian>& priors, Workers& workers) {
  const double ring = config_.of_policy.places.ring;
  Association association{std::vector<Sight>(particles.size()), array.observations};
  workers.forEach(particles.size(), [&](std::size_t i, unsigned lane) {
    const PlaceCandidates source(array, index, descriptors_, particles[i].map, priors[i], model,
                                 ring * ring * config_.gate);
    association.sights[i] = ask(array, source, lane);
  });
  const auto& best = particles.best();
  for (const auto& match : association.of(best).matches)
    association.seen[match.column].id = index.id(particles[best].map[match.slot].number);
  return association;
}

Sight Associator::ask(const LandmarkObservationArray& array, const Source& source,
                      std::size_t lane) {
  using Kind = Decision::Kind;
  auto& [policy, decisions] = lanes_[lane];
  policy->decide(array, source, config_.map_is_fixed, decisions);
  decisions.resize(array.observations.size());
  evidence_.hold(array, decisions);
  Sight sight;
  sight.sensor = array.sensor_pose;
  sight.gate = config_.gate;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const bool is_offered = decisions[i].landmark < source.size();
    const auto kind = decisions[i].checked(config_.map_is_fixed, is_offered);
    if (kind == Kind::kLandmark)
      sight.matches.push_back({decisions[i].landmark, i, array.observations[i]});
    if (kind == Kind::kNew) sight.unseen.push_back(i);
    sight.kinds.push_back(kind);
  }
  return sight;
}

}  // namespace slam::particle_filter
