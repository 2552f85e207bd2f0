// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_update.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace slam::particle_filter {
namespace {

using grid_map::CorrelativeMatching;
using grid_map::HillClimbing;
using grid_map::Tile;

UpdateTrigger triggerOf(const ScanConfig& config) {
  return {config.update_distance, config.update_angle, durationFromSeconds(config.update_interval)};
}

std::unique_ptr<grid_map::ScanMatcher> matcherOf(const ScanConfig& config) {
  const HillClimbing::Steps steps{config.step_position, config.step_heading, config.step_halvings};
  if (config.matcher == ScanConfig::Matcher::kHillClimbing)
    return std::make_unique<HillClimbing>(steps);
  return std::make_unique<CorrelativeMatching>(
      CorrelativeMatching::Window{config.window_position, config.window_heading}, steps);
}

std::unique_ptr<ScanProposal> proposalOf(const ScanConfig& config) {
  if (config.proposal == ScanConfig::Proposal::kMotion)
    return std::make_unique<MotionScanProposal>();
  return std::make_unique<MatchedScanProposal>(matcherOf(config));
}

std::unique_ptr<ScanWeighting> weightingOf(const ScanConfig& config) {
  if (config.weighting == ScanConfig::Weighting::kLikelihood)
    return std::make_unique<LikelihoodScanWeighting>();
  return std::make_unique<IntegralScanWeighting>();
}

}  // namespace

ScanUpdate::ScanUpdate(const grid_map::GridMapConfig& map, const ScanConfig& scan,
                       bool map_is_fixed)
    : map_config_(map),
      config_(scan),
      map_is_fixed_(map_is_fixed),
      model_(map),
      likelihood_(scan.outlier, scan.beam_information),
      proposal_(proposalOf(scan)),
      weighting_(weightingOf(scan)),
      trigger_(triggerOf(scan)),
      fit_(model_, scan.lost_share) {
  relocate({});
}

void ScanUpdate::relocate(const PoseEstimate& around) {
  trigger_ = triggerOf(config_);
  fit_.forget();
  Eigen::Matrix3d to_robot = Eigen::Matrix3d::Identity();
  to_robot.topLeftCorner<2, 2>() = around.pose.rotation().transpose();
  motion_.emplace();
  motion_->covariance = to_robot * around.covariance * to_robot.transpose();
}

void ScanUpdate::move(const Motion& motion) {
  trigger_.move(motion.increment);
  motion_ = motion_ ? joined(*motion_, motion) : motion;
}

bool ScanUpdate::take(const LaserScan& scan) {
  if (!trigger_.isDue(scan.stamp)) return false;
  stamp_ = scan.stamp;
  scan_ = pointsOf(scan, model_, config_.spacing);
  return !scan_.beams.empty();
}

Eigen::Matrix3d ScanUpdate::covarianceAt(const Pose2& pose) const {
  if (!motion_) return Eigen::Matrix3d::Zero();
  const Pose2 start = pose * motion_->increment.inverse();
  Eigen::Matrix3d J_u;
  start.compose(motion_->increment, nullptr, &J_u);
  return J_u * motion_->covariance * J_u.transpose();
}

Drafts ScanUpdate::propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                           const PoseBelief&, const Execution& execution) {
  Drafts drafts(particles.size());
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned) {
    const auto& grid = particles[i].grid;
    auto& prior = drafts.priors[i];
    prior.mean = particles[i].pose;
    if (motion) prior = prior.moved(*motion);
    prior.covariance = covarianceAt(prior.mean);
    auto stream = execution.streams.of(RandomStreams::Purpose::kPropose, i);
    const auto draft = proposal_->propose(likelihood_, scan_, grid, prior, stream);
    drafts.proposals[i] = draft.pose;
    drafts.log_factors[i] =
        weighting_->logFactor(likelihood_, scan_, grid, draft) / config_.weight_smoothing;
  });
  return drafts;
}

/// Nothing is known beyond the particles' spread.
void ScanUpdate::inform(const PoseEstimate& moments, const ParticleSet&,
                        KnowledgeBound& bound) const {
  bound.setPose(moments.covariance);
}

Lesson ScanUpdate::learn(ParticleSet& particles, const Ancestors&, PoseBelief&,
                         const Execution& execution, Account& account) {
  const auto& best = particles[particles.best()];
  fit_.judge(best.grid, scan_, best.pose);
  account.figures["contradicting_ends"] = fit_.contradictingShare();
  trigger_.restart(stamp_);
  motion_.reset();
  return map_is_fixed_ ? Lesson() : insert(particles, execution, account);
}

Lesson ScanUpdate::insert(ParticleSet& particles, const Execution& execution,
                          Account& account) const {
  if (!hasRoomFor(particles.size(), particles.memory().grids)) {
    account.counters.add("scans_without_memory");
    return {Status::warning(
        "the particles' grid maps would need more than grid_map.largest_memory and are kept as "
        "they are: raise it or grid_map.resolution, or lower pf.particles")};
  }
  std::atomic<std::size_t> beyond{0};
  execution.workers->forEach(particles.size(), [&](std::size_t i, unsigned) {
    beyond += grid_map::insertScan(model_, scan_, particles[i].pose, particles[i].grid);
  });
  account.counters.add("beams_beyond_map", beyond);
  if (beyond == 0) return {Status::ok(), true};
  return {Status::warning("beams end beyond the largest grid map, what lies there is not mapped: "
                          "raise grid_map.largest_area"),
          true};
}

bool ScanUpdate::hasRoomFor(std::size_t maps, const grid_map::GridMap::Memory& memory) const {
  Eigen::Vector2d least = scan_.origin, most = scan_.origin;
  for (const auto& beam : scan_.beams) {
    least = least.cwiseMin(beam.end);
    most = most.cwiseMax(beam.end);
  }
  // in whatever direction it lies, and with a tile begun on either side
  const double diagonal = (most - least).norm() / Tile::kSize + 2.0;
  const Eigen::Array2d edges = (most - least).array() / Tile::kSize + 2.0;
  const double tiles = std::min(edges.prod() * 2.0, diagonal * diagonal);
  const double bytes = static_cast<double>(maps) * tiles * sizeof(Tile);
  constexpr double kMegabyte = 1e6;
  return static_cast<double>(memory.bytes()) + bytes <= kMegabyte * map_config_.largest_memory;
}

std::size_t ScanUpdate::mostTiles() const {
  const double edge = Tile::kSize * map_config_.resolution;
  return static_cast<std::size_t>(std::ceil(map_config_.largest_area / (edge * edge)));
}

}  // namespace slam::particle_filter
