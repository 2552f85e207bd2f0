// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/landmark_update.hpp"

#include <cmath>

#include "slam_core/association/decision_record.hpp"
#include "slam_core/association/gate.hpp"
#include "slam_core/association/sightings.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"

namespace slam::particle_filter {

namespace {

using association::gateOf;
using Kind = association::Decision::Kind;

void count(const Sight& sight, Account& account) {
  for (const auto kind : sight.kinds) {
    if (kind == Kind::kLandmark || kind == Kind::kNew) continue;
    account.counters.add(association::reasonOf(kind));
    account.statistics.unknown += kind == Kind::kDuplicate ? 0 : 1;
  }
}

PoseGaussian priorOf(const Particle& particle, const std::optional<Motion>& motion) {
  const PoseGaussian before{particle.pose};
  return motion ? before.moved(*motion) : before;
}

}  // namespace

LandmarkUpdate::LandmarkUpdate(const Config& config)
    : map_is_fixed_(config.map_is_fixed),
      associator_({config.association,
                   config.lanes,
                   gateOf(config.gate_probability),
                   config.map_is_fixed,
                   {config.gate_probability, config.places}}),
      proposal_(makeProposal(config.proposal)),
      weighting_(makeWeighting(config.weighting)),
      fit_(config.lost_nis, gateOf(config.gate_probability)) {}

void LandmarkUpdate::load(const LandmarkMap& map) {
  index_.clear();
  for (const auto& landmark : map) index_.append(landmark.id);
  associator_.restart(map);
}

bool LandmarkUpdate::take(const std::optional<LandmarkObservationArray>& array, Account& account) {
  array_ = array.value_or(LandmarkObservationArray());
  association_ = {};
  if (associator_.asksEach()) {
    if (array) associator_.see(array_);
    return has_seen_ = !array_.observations.empty();
  }
  association_ = associator_.forAll(array_, index_);
  count(association_.of(0), account);
  return has_seen_ = !association_.of(0).isEmpty();
}

Drafts LandmarkUpdate::propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                               const PoseBelief& belief, const Execution& execution) {
  Drafts drafts(particles.size());
  auto& workers = *execution.workers;
  const auto* const place = belief.told_place && mayMatch() ? &*belief.told_place : nullptr;
  workers.forEach(particles.size(), [&](std::size_t i, unsigned) {
    drafts.priors[i] = place ? *place : priorOf(particles[i], motion);
  });
  if (associator_.asksEach() && has_seen_)
    association_ = associator_.forEach(array_, index_, model_, particles, drafts.priors, workers);
  predictions_.resize(particles.size() * association_.seen.size());
  workers.forEach(particles.size(), [&](std::size_t i, unsigned) {
    auto stream = execution.streams.of(RandomStreams::Purpose::kPropose, i);
    auto* const predictions = predictions_.data() + i * association_.seen.size();
    expectNothing(association_.of(i), predictions);
    drafts.proposals[i] = proposal_->propose(model_, association_.of(i), particles[i].map,
                                             drafts.priors[i], stream, predictions);
    drafts.log_factors[i] = weighting_->logFactor(predictions, association_.seen.size());
  });
  return drafts;
}

bool LandmarkUpdate::mayMatch() const {
  return associator_.asksEach() ? has_seen_ : !association_.of(0).matches.empty();
}

/// Predicts the observations that the particle takes for no landmark of its map.
void LandmarkUpdate::expectNothing(const Sight& sight, Prediction* predictions) const {
  const auto& seen = association_.seen;
  if (sight.matches.size() == seen.size()) return;
  for (std::size_t column = 0; column < seen.size(); ++column)
    predictions[column] = unmatchedPrediction(seen[column], sight.gate);
}

void LandmarkUpdate::judge(const Weights& weights, Account& account) {
  auto& statistics = account.statistics;
  is_used_ = fit_.judge(predictions_, association_.seen, weights.all(), statistics);
  account.counters.add("gated", static_cast<std::uint64_t>(statistics.gated));
  account.counters.add("doubtful", isDoubtful());
  account.figures["recent_nis"] = fit_.recentNis();
}

void LandmarkUpdate::inform(const PoseEstimate& moments, const ParticleSet& particles,
                            KnowledgeBound& bound) const {
  const auto best = particles.best();
  const auto& sight = association_.of(best);
  for (const auto& [slot, column, z] : sight.matches) {
    if (!is_used_[column]) continue;
    const auto& landmark = particles[best].map[slot];
    bound.observe(model_, moments.pose, sight.sensor, landmark.mean(), landmark.number, z,
                  map_is_fixed_);
  }
}

double LandmarkUpdate::logCorrection(const Drafts& drafts, std::size_t ancestor,
                                     const Particle& drawn) const {
  return weighting_->logCorrection(model_, association_.of(ancestor), drawn.map,
                                   drafts.priors[ancestor], drafts.proposals[ancestor], drawn.pose,
                                   predictionsOf(ancestor));
}

Lesson LandmarkUpdate::learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
                             const Execution& execution, Account& account) {
  const auto best = particles.best();
  const auto& sight = association_.of(ancestors[best]);
  if (associator_.asksEach()) count(sight, account);
  if (associator_.asksEach()) record(particles[best], sight, account);
  if (map_is_fixed_ || !has_seen_ || isDoubtful()) return {};
  describe(particles[best], sight);
  begin(ancestors, belief);
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned lane) {
    updateMap(particles[i], ancestors[i], lane);
  });
  const auto told =
      beginAnew(particles[best], sight, predictionsOf(ancestors[best]), belief, account);
  account.statistics.added = static_cast<int>(sight.unseen.size());
  if (associator_.asksEach()) removeGhosts(particles[best], sight, account);
  return {told, false};
}

/// Descriptors depend on no pose: what the most likely particle takes the observations for holds
/// for all of them.
void LandmarkUpdate::describe(const Particle& best, const Sight& sight) {
  for (const auto& [slot, column, z] : sight.matches)
    if (is_used_[column]) associator_.describe(index_.id(best.map[slot].number), z);
}

/// Records the landmarks for which the most likely particle takes the observations.
void LandmarkUpdate::record(const Particle& best, const Sight& sight, Account& account) const {
  auto& record = account.statistics.associations;
  record = association::recordOf(array_, sight.kinds);
  for (const auto& [slot, column, z] : sight.matches) {
    record[column].landmark = index_.id(best.map[slot].number);
    if (!is_used_[column]) record[column].taken_for = TakenFor::kGated;
  }
}

void LandmarkUpdate::removeGhosts(const Particle& best, const Sight& sight, Account& account) {
  std::vector<LandmarkId> seen;
  for (const auto& [slot, column, z] : sight.matches)
    if (is_used_[column]) seen.push_back(index_.id(best.map[slot].number));
  for (const auto i : sight.unseen)
    account.statistics.associations[i].landmark = index_.id(begun_[i]);
  std::vector<association::LandmarkPlace> places;
  for (std::size_t slot = 0; slot < best.map.size(); ++slot)
    if (const auto number = best.map[slot].number; !index_.isRetired(number))
      places.push_back({index_.id(number), best.map[slot].mean()});
  for (const auto id : associator_.ghosts(best.pose * sight.sensor, places, seen)) {
    index_.retire(*index_.find(id));
    account.counters.add("ghost");
  }
}

Status LandmarkUpdate::remove(LandmarkId id, Account& account) {
  const auto number = index_.find(id);
  const auto removal = removalOf(id, number.has_value(), map_is_fixed_);
  if (!removal.isOk()) return removal;
  index_.retire(*number);
  established_.erase(id);
  associator_.forget(id);
  account.counters.add("removed");
  return removal;
}

/// Gives numbers to the landmarks that are new to any of the particles that are left.
void LandmarkUpdate::begin(const Ancestors& ancestors, PoseBelief& belief) {
  const auto& observations = array_.observations;
  std::vector<bool> is_new(observations.size());
  for (const auto ancestor : ancestors)
    for (const auto i : association_.of(ancestor).unseen) is_new[i] = true;
  begun_.resize(observations.size());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (!is_new[i]) continue;
    const auto number = index_.size();
    begun_[i] = static_cast<std::uint32_t>(number);
    belief.bound.begin(model_, belief.estimate.pose, array_.sensor_pose, number, observations[i]);
    index_.append(associator_.asksEach() ? kUnknownId : observations[i].id);
    associator_.describe(index_.id(number), observations[i]);
  }
}

/// A landmark that does not fit loses credit only where the particle, and the filter as a whole,
/// can be trusted instead of it.
void LandmarkUpdate::updateMap(Particle& particle, std::size_t ancestor, unsigned lane) const {
  const auto& pose = particle.pose;
  auto& map = particle.map;
  const auto& sight = association_.of(ancestor);
  const auto* const predictions = predictionsOf(ancestor);
  const bool is_trusted =
      !fit_.isLost() && !particle_filter::isDoubtful(predictions, association_.seen.size());
  map.prefetch(sight.matches);
  for (const auto& [slot, column, z] : sight.matches) {
    const bool fits = !predictions[column].gated;
    if (fits || is_trusted) takeSighting(model_, pose, sight.sensor, z, fits, map.edit(slot, lane));
  }
  for (const auto i : sight.unseen) {
    auto landmark = initialized(model_, pose, sight.sensor, array_.observations[i]);
    landmark.number = begun_[i];
    map.push_back(landmark, lane);
  }
}

/// Reports which landmarks the best particle has re-initialised, to the belief and as a status.
Status LandmarkUpdate::beginAnew(const Particle& best, const Sight& sight,
                                 const Prediction* predictions, PoseBelief& belief,
                                 Account& account) {
  auto told = Status::ok();
  for (const auto& [slot, column, z] : sight.matches) {
    const auto& landmark = best.map[slot];
    if (predictions[column].established) established_.insert(index_.id(landmark.number));
    if (is_used_[column]) continue;
    if (landmark.mean() != initialized(model_, best.pose, sight.sensor, z).mean()) continue;
    belief.bound.begin(model_, belief.estimate.pose, sight.sensor, landmark.number, z);
    told = moreUrgent(countBegunAnew(z, landmark.number, account), told);
  }
  return told;
}

Status LandmarkUpdate::countBegunAnew(const LandmarkObservation& z, std::size_t number,
                                      Account& account) {
  const auto id = index_.id(number);
  const bool was_established = established_.erase(id) > 0;
  account.counters.add("begun_anew");
  if (!index_.isRetired(number) && associator_.distrusts(id, was_established)) {
    index_.retire(number);
    account.counters.add("distrusted");
    return association::DistrustedIds::warningOf(id);
  }
  return was_established ? association::Sightings::warningOf({z, true}, true) : Status::ok();
}

}  // namespace slam::particle_filter
