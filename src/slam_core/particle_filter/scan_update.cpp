// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scan_update.hpp"

#include <algorithm>
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
  if (config.matcher == "hill_climbing") return std::make_unique<HillClimbing>(steps);
  return std::make_unique<CorrelativeMatching>(
      CorrelativeMatching::Window{config.window_position, config.window_heading}, steps);
}

std::unique_ptr<ScanProposal> proposalOf(const ScanConfig& config) {
  if (config.proposal == "motion") return std::make_unique<MotionScanProposal>();
  return std::make_unique<MatchedScanProposal>(matcherOf(config));
}

}  // namespace

ScanUpdate::ScanUpdate(const grid_map::GridMapConfig& map, const ScanConfig& scan)
    : map_config_(map),
      config_(scan),
      model_(map),
      likelihood_(scan.outlier, scan.beam_information),
      proposal_(proposalOf(scan)),
      weighting_(makeScanWeighting(scan.weighting)),
      trigger_(triggerOf(scan)),
      fit_(model_, scan.lost_share) {}

void ScanUpdate::restart(const PoseEstimate& around) {
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

std::optional<grid_map::ScanPoints> ScanUpdate::take(const LaserScan& scan) const {
  if (!trigger_.isDue(scan.stamp)) return std::nullopt;
  auto points = pointsOf(scan, model_, config_.spacing);
  if (points.beams.empty()) return std::nullopt;
  return points;
}

void ScanUpdate::markTaken(Stamp stamp) {
  trigger_.restart(stamp);
  motion_.reset();
}

Eigen::Matrix3d ScanUpdate::covarianceAt(const Pose2& pose) const {
  if (!motion_) return Eigen::Matrix3d::Zero();
  const Pose2 start = pose * motion_->increment.inverse();
  Eigen::Matrix3d J_u;
  start.compose(motion_->increment, nullptr, &J_u);
  return J_u * motion_->covariance * J_u.transpose();
}

PoseGaussian ScanUpdate::propose(const grid_map::ScanPoints& scan, const grid_map::GridMap& map,
                                 const PoseGaussian& prior, RandomStream& random,
                                 double& log_factor) const {
  const auto draft = proposal_->propose(likelihood_, scan, map, prior, random);
  log_factor = weighting_->logFactor(likelihood_, scan, map, draft) / config_.weight_smoothing;
  return draft.pose;
}

bool ScanUpdate::hasRoomFor(const grid_map::ScanPoints& scan, std::size_t maps,
                            const grid_map::GridMap::Memory& memory) const {
  Eigen::Vector2d least = scan.origin, most = scan.origin;
  for (const auto& beam : scan.beams) {
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
