// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_update.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "slam_core/grid_map/scan_insertion.hpp"

namespace slam::particle_filter {
namespace {

UpdateTrigger triggerOf(const ScanConfig& config) {
  return {config.update_distance, config.update_angle, durationFromSeconds(config.update_interval)};
}

scan_matching::MapDrift driftOf(const ScanConfig& config, bool map_is_fixed) {
  if (map_is_fixed) return {0.0, 0.0};
  return {config.drift_position, config.drift_heading};
}

std::unique_ptr<ScanProposal> proposalOf(const ScanConfig& config,
                                         const scan_matching::MatcherConfig& matcher) {
  if (config.proposal == ScanConfig::Proposal::kMotion)
    return std::make_unique<MotionScanProposal>();
  return std::make_unique<MatchedScanProposal>(matcher);
}

std::unique_ptr<ScanWeighting> weightingOf(const ScanConfig& config) {
  if (config.weighting == ScanConfig::Weighting::kLikelihood)
    return std::make_unique<LikelihoodScanWeighting>();
  return std::make_unique<IntegralScanWeighting>();
}

}  // namespace

ScanUpdate::ScanUpdate(const grid_map::GridMapConfig& map, const ScanConfig& scan,
                       const scan_matching::MatcherConfig& matcher, bool map_is_fixed)
    : map_config_(map),
      config_(scan),
      spacing_(matcher.spacing),
      map_is_fixed_(map_is_fixed),
      models_(scan_matching::levelModels(map)),
      evidence_(scan.outlier, scan.unknown, scan.beam_information),
      proposal_(proposalOf(scan, matcher)),
      weighting_(weightingOf(scan)),
      follower_(matcher, {scan.drift_position, scan.drift_heading}),
      drift_(driftOf(scan, map_is_fixed)),
      trigger_(triggerOf(scan)),
      doubt_(scan.lost_share, matcher.false_alarm_hours, map_is_fixed) {
  restart({});
}

void ScanUpdate::restart(const PoseEstimate& first) {
  relocate({first.pose});
  drift_.restart(first);
}

void ScanUpdate::restartInLoadedMap(const Pose2& robot) {
  relocate({robot});
  drift_.restartInLoadedMap(robot);
}

void ScanUpdate::relocate(const PoseEstimate& around) {
  trigger_ = triggerOf(config_);
  doubt_.forget();
  watch_.restart();
  follower_.restart();
  drift_.relocate(around.pose);
  Eigen::Matrix3d to_robot = Eigen::Matrix3d::Identity();
  to_robot.topLeftCorner<2, 2>() = around.pose.rotation().transpose();
  told_.emplace();
  told_->covariance = to_robot * around.covariance * to_robot.transpose();
}

void ScanUpdate::move(const Motion& motion) { follower_.move(motion); }

bool ScanUpdate::take(const LaserScan& scan, const Particle& best, const Pose2& pose,
                      Account& account) {
  correction_ = {};
  auto levels = scan_matching::pointsOf(scan, models_, spacing_);
  const auto map = mapOf(best);
  const auto found = follower_.follow(map, levels, scan.stamp, pose, driftAt(pose));
  watch_.note(levels, map.isEmpty(), found, true, account.counters);
  if (!map_is_fixed_) drift_.follow(follower_.robot(), found, follower_.fittedEnds(map, levels));
  doubt_.judge(found, scan.stamp);
  correction_ = follower_.correction();
  motion_ = follower_.motion();
  if (levels.front().beams.empty() || !trigger_.isDue(motion_.increment, scan.stamp)) return false;
  if (told_) motion_ = joined(*told_, motion_);
  stamp_ = scan.stamp;
  scan_ = std::move(levels);
  return true;
}

scan_matching::MapView ScanUpdate::mapOf(const Particle& particle) const {
  return {{{{models_[0], particle.grid}, {models_[1], particle.coarse_grid}}}};
}

ScanInMap ScanUpdate::inMapOf(const Particle& particle) const {
  return {scan_, mapOf(particle), evidence_};
}

Eigen::Matrix3d ScanUpdate::covarianceAt(const Pose2& pose) const {
  const Pose2 start = pose * motion_.increment.inverse();
  Eigen::Matrix3d J_u;
  start.compose(motion_.increment, nullptr, &J_u);
  return J_u * motion_.covariance * J_u.transpose();
}

std::optional<Eigen::Matrix3d> ScanUpdate::driftAt(const Pose2& pose) const {
  return map_is_fixed_ ? std::nullopt : std::optional(drift_.covarianceAt(pose));
}

Drafts ScanUpdate::propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                           const PoseBelief&, const Execution& execution) {
  Drafts drafts(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto& prior = drafts.priors[i];
    prior.mean = motion ? particles[i].pose * motion->increment : particles[i].pose;
    prior.covariance = covarianceAt(prior.mean);
  }
  const auto best = particles.best();
  const auto elsewhere = proposal_->search(inMapOf(particles[best]), drafts.priors[best],
                                           driftAt(drafts.priors[best].mean));
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned) {
    const auto scan = inMapOf(particles[i]);
    auto stream = execution.streams.of(RandomStreams::Purpose::kPropose, i);
    const auto draft = proposal_->propose(scan, drafts.priors[i], elsewhere, stream);
    drafts.proposals[i] = draft.pose;
    drafts.log_factors[i] = weighting_->logFactor(scan, draft) / config_.weight_smoothing;
  });
  return drafts;
}

/// What all particles have in common, how far the map has turned above all, their spread does not
/// show.
void ScanUpdate::inform(const PoseEstimate& moments, const ParticleSet&,
                        KnowledgeBound& bound) const {
  const Eigen::Matrix3d drifted = follower_.robot().covariance + drift_.covarianceAt(moments.pose);
  bound.setPose(atLeast<3>(drifted, moments.covariance));
}

Lesson ScanUpdate::learn(ParticleSet& particles, const Ancestors&, PoseBelief&,
                         const Execution& execution, Account& account) {
  trigger_.restart(stamp_);
  follower_.beginMotion();
  told_.reset();
  if (!doubt_.admits()) account.counters.add("contradicting");
  return map_is_fixed_ || !doubt_.admits() ? Lesson() : insert(particles, execution, account);
}

Lesson ScanUpdate::insert(ParticleSet& particles, const Execution& execution, Account& account) {
  if (!hasRoomFor(particles.size(), particles.memory().grids)) {
    account.counters.add("scans_without_memory");
    return {Status::warning(
        "the particles' grid maps would need more than grid_map.largest_memory and are kept as "
        "they are: raise it or grid_map.resolution, or lower pf.particles")};
  }
  std::atomic<std::size_t> beyond{0};
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned) {
    auto& particle = particles[i];
    beyond += grid_map::insertScan(models_[0], scan_[0], particle.pose, particle.grid);
    grid_map::insertScan(models_[1], scan_[1], particle.pose, particle.coarse_grid);
  });
  drift_.add(scan_[0], particles[particles.best()].pose);
  account.counters.add("beams_beyond_map", beyond);
  if (beyond == 0) return {Status::ok(), true};
  return {Status::warning("beams end beyond the largest grid map, what lies there is not mapped: "
                          "raise grid_map.largest_area"),
          true};
}

bool ScanUpdate::hasRoomFor(std::size_t maps, const grid_map::GridMap::Memory& memory) const {
  const double bytes = static_cast<double>(maps) * scan_matching::mostBytesFor(scan_);
  return grid_map::isWithinMemory(static_cast<double>(memory.bytes()) + bytes, map_config_);
}

}  // namespace slam::particle_filter
