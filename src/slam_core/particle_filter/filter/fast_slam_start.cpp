// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

namespace slam::particle_filter {
namespace {

const Registrar<Backend, FastSlam> kRegistrar("pf");
const SectionRegistrar<PfConfig> kSectionRegistrar;
const SectionRegistrar<grid_map::GridMapConfig> kGridMapRegistrar;
const SectionRegistrar<ScanConfig> kScanRegistrar;
const SectionRegistrar<scan_matching::MatcherConfig> kMatcherRegistrar;

/// Pose and map are those of one particle; as long as others are about as likely nothing should
/// jump.
constexpr double kWorthAnotherMap = 10.0;

}  // namespace

void FastSlam::configure(const PfConfig& config, const grid_map::GridMapConfig& grid,
                         const ScanConfig& scan, const scan_matching::MatcherConfig& matcher) {
  FaultCollector faults;
  faults.attempt([&] { validatePf(config); });
  if (uses_grid_) faults.attempt([&] { validate(grid); });
  if (uses_grid_) faults.attempt([&] { validate(scan); });
  if (uses_grid_) faults.attempt([&] { validate(matcher); });
  faults.raise();
  config_ = config;
  scans_.reset();
  if (uses_grid_) scans_.emplace(grid, scan, matcher, config_.mapIsFixed());
  resampler_ = Resampler(resamplingOf(config));
  execution_.workers = std::make_unique<Workers>(static_cast<unsigned>(config.threads));
  reset();
}

void FastSlam::configure(Settings& settings) {
  PfConfig config;
  grid_map::GridMapConfig grid;
  ScanConfig scan;
  scan_matching::MatcherConfig matcher;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  config.association = association_;
  if (uses_grid_) faults.attempt([&] { settings.read(grid); });
  if (uses_grid_) faults.attempt([&] { settings.read(scan); });
  if (uses_grid_) faults.attempt([&] { settings.read(matcher); });
  faults.raise();
  configure(config, grid, scan, matcher);
}

void FastSlam::reset() {
  execution_.streams.restart();
  particles_ = std::make_unique<ParticleSet>(static_cast<std::size_t>(config_.particles),
                                             static_cast<unsigned>(config_.threads),
                                             scans_ ? scans_->mostTiles() : 0);
  if (scans_) particles_->requireToBecomeBest(kWorthAnotherMap);
  landmarks_ = LandmarkUpdate(landmarksOf(config_));
  inputs_ = {};
  account_ = {};
  is_corrected_ = false;
  shown_grid_ = {nullptr, shown_grid_.revision + 1};
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  belief_ = {};
  belief_.estimate = {Pose2(), sigma.cwiseAbs2().asDiagonal()};
  belief_.bound.restart(belief_.estimate.covariance);
  if (scans_) scans_->restart(belief_.estimate);
  auto stream = execution_.streams.of(RandomStreams::Purpose::kPlace);
  particle_filter::relocate(*particles_, Pose2(), belief_.estimate, stream);
}

Status FastSlam::replaceMap() {
  if (!inputs_.map) return Status::ok();
  const auto map = *std::exchange(inputs_.map, std::nullopt);
  grid_map::GridMap grid(particles_->memory().grids), coarse(particles_->memory().grids);
  Status status;
  if (scans_ && map.grid) {
    status = fillFrom(*map.grid, scans_->models()[0], grid);
    status = moreUrgent(fillFrom(*map.grid, scans_->models()[1], coarse), status);
  }
  if (status.level == Status::Level::kError) return status;  // all stays as it is
  shown_grid_ = {grid.identity(), shown_grid_.revision + 1};
  const bool has_joint = map.joint_covariance.size() > 0;
  const double inflation = has_joint ? 1.0 : config_.load_inflation;
  particles_->replaceMaps(map.landmarks, inflation, grid, coarse);
  landmarks_.load(map.landmarks);
  if (scans_) scans_->restartInLoadedMap(map.robot.pose);
  belief_.bound.load(map.landmarks, inflation);
  if (!inputs_.initial_pose) inputs_.initial_pose = map.robot;
  return status;
}

void FastSlam::relocate() {
  if (!inputs_.initial_pose) return;
  const auto place = *std::exchange(inputs_.initial_pose, std::nullopt);
  auto drawn = place;
  if (scans_) drawn.covariance *= 0.5;  // the other half is what a scan looks around each of them
  if (scans_) scans_->relocate(drawn);
  landmarks_.relocate();
  auto stream = execution_.streams.of(RandomStreams::Purpose::kPlace);
  particle_filter::relocate(*particles_, carriedIncrement(), drawn, stream);
  belief_.carried.reset();
  belief_.estimate = place;
  belief_.bound.setPose(place.covariance);
  belief_.told_place = {place.pose, place.covariance};
}

}  // namespace slam::particle_filter
