// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/landmark_update.hpp"

#include <cmath>
#include <set>

#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"

namespace slam::particle_filter {

// the quantile of the chi-square distribution with two degrees of freedom has a closed form
LandmarkUpdate::LandmarkUpdate(const Config& config)
    : map_is_fixed_(config.map_is_fixed),
      proposal_(makeProposal(config.proposal)),
      weighting_(makeWeighting(config.weighting)),
      fit_(config.lost_nis) {
  sight_.gate = -2.0 * std::log(1.0 - config.gate_probability);
}

void LandmarkUpdate::load(const LandmarkMap& map) {
  index_.clear();
  for (const auto& landmark : map) index_.append(landmark.id);
}

bool LandmarkUpdate::take(const std::optional<LandmarkObservationArray>& array, Account& account) {
  sight_.matches.clear();
  unseen_.clear();
  if (!array) return false;
  sight_.sensor = array->sensor_pose;
  std::set<LandmarkId> seen;
  for (const auto& z : array->observations) {
    if (z.id != kUnknownId && !seen.insert(z.id).second)
      account.counters.add("duplicate");
    else
      sort(z, account);
  }
  return hasSeen();
}

void LandmarkUpdate::sort(const LandmarkObservation& z, Account& account) {
  if (z.id == kUnknownId) {
    ++account.statistics.unknown;
    account.counters.add("unknown_id");
  } else if (const auto slot = index_.find(z.id)) {
    sight_.matches.push_back({*slot, z});
  } else if (map_is_fixed_) {
    ++account.statistics.unknown;
    account.counters.add("not_in_map");
  } else {
    unseen_.push_back(z);
  }
}

Drafts LandmarkUpdate::propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                               const PoseBelief& belief, const Execution& execution) {
  const auto matches = sight_.matches.size();
  Drafts drafts(particles.size());
  predictions_.resize(particles.size() * matches);
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned) {
    auto& prior = drafts.priors[i];
    prior.mean = particles[i].pose;
    if (motion) prior = prior.moved(*motion);
    if (belief.told_place && matches > 0) prior = *belief.told_place;
    auto stream = execution.streams.of(RandomStreams::Purpose::kPropose, i);
    auto* const predictions = predictions_.data() + i * matches;
    drafts.proposals[i] =
        proposal_->propose(model_, sight_, particles[i].map, prior, stream, predictions);
    drafts.log_factors[i] = weighting_->logFactor(predictions, matches);
  });
  return drafts;
}

void LandmarkUpdate::judge(const Weights& weights, Account& account) {
  auto& statistics = account.statistics;
  fit_.judge(predictions_, sight_, weights.all(), statistics);
  is_used_.clear();
  for (const auto& innovation : statistics.innovations) is_used_.push_back(innovation.used);
  account.counters.add("gated", static_cast<std::uint64_t>(statistics.gated));
  account.counters.add("doubtful", isDoubtful());
  account.figures["recent_nis"] = fit_.recentNis();
}

void LandmarkUpdate::inform(const PoseEstimate& moments, const Particle& best,
                            KnowledgeBound& bound) const {
  const auto& [sensor, matches, gate] = sight_;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& [slot, z] = matches[k];
    if (is_used_[k])
      bound.observe(model_, moments.pose, sensor, best.map[slot].mean(), slot, z, map_is_fixed_);
  }
}

double LandmarkUpdate::logCorrection(const Drafts& drafts, std::size_t ancestor,
                                     const Particle& drawn) const {
  return weighting_->logCorrection(model_, sight_, drawn.map, drafts.priors[ancestor],
                                   drafts.proposals[ancestor], drawn.pose, predictionsOf(ancestor));
}

Lesson LandmarkUpdate::learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
                             const Execution& execution, Account& account) {
  if (map_is_fixed_ || !hasSeen() || isDoubtful()) return {};
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned lane) {
    updateMap(particles[i], predictionsOf(ancestors[i]), lane);
  });
  beginAnew(particles.best(), belief);
  for (const auto& z : unseen_) {
    belief.bound.begin(model_, belief.estimate.pose, sight_.sensor, index_.size(), z);
    index_.append(z.id);
  }
  account.statistics.added = static_cast<int>(unseen_.size());
  return {};
}

/// A landmark that does not fit loses credit only where the particle, and the filter as a whole,
/// can be trusted instead of it.
void LandmarkUpdate::updateMap(Particle& particle, const Prediction* predictions,
                               unsigned lane) const {
  auto& [pose, map, grid, path] = particle;
  const auto& [sensor, matches, gate] = sight_;
  const bool is_trusted =
      !fit_.isLost() && !particle_filter::isDoubtful(predictions, matches.size());
  map.prefetch(matches);
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& [slot, z] = matches[k];
    const bool fits = !predictions[k].gated;
    if (fits || is_trusted) takeSighting(model_, pose, sensor, z, fits, map.edit(slot, lane));
  }
  for (const auto& z : unseen_) map.push_back(initialized(model_, pose, sensor, z), lane);
}

/// Where the best particle has.
void LandmarkUpdate::beginAnew(const Particle& best, PoseBelief& belief) const {
  const auto& [sensor, matches, gate] = sight_;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (is_used_[k]) continue;
    const auto& [slot, z] = matches[k];
    const auto anew = initialized(model_, best.pose, sensor, z);
    if (best.map[slot].mean() == anew.mean())
      belief.bound.begin(model_, belief.estimate.pose, sensor, slot, z);
  }
}

}  // namespace slam::particle_filter
