// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/fast_slam.hpp"

#include <numeric>
#include <set>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/particle_filter/association.hpp"
#include "slam_core/particle_filter/hilbert_order.hpp"
#include "slam_core/particle_filter/landmark_filter.hpp"
#include "slam_core/particle_filter/map_update.hpp"
#include "slam_core/particle_filter/mixture.hpp"

namespace slam::particle_filter {
namespace {

const Registrar<Backend, FastSlam> kRegistrar("pf");
const SectionRegistrar<PfConfig> kSectionRegistrar;
const SectionRegistrar<grid_map::GridMapConfig> kGridMapRegistrar;
const SectionRegistrar<ScanConfig> kScanRegistrar;

using Purpose = RandomStreams::Purpose;

void append(const Motion& motion, std::optional<Motion>& sum) {
  sum = sum ? joined(*sum, motion) : motion;
}

}  // namespace

void FastSlam::configure(const PfConfig& config, const grid_map::GridMapConfig& grid,
                         const ScanConfig& scan) {
  FaultCollector faults;
  faults.attempt([&] { validatePf(config); });
  if (uses_grid_) faults.attempt([&] { validate(grid); });
  if (uses_grid_) faults.attempt([&] { validate(scan); });
  faults.raise();
  config_ = config;
  scans_.reset();
  if (uses_grid_) scans_.emplace(grid, scan);
  policies_ = Policies(config);
  workers_ = std::make_unique<Workers>(static_cast<unsigned>(config.threads));
  reset();
}

void FastSlam::configure(Settings& settings) {
  PfConfig config;
  grid_map::GridMapConfig grid;
  ScanConfig scan;
  FaultCollector faults;
  faults.attempt([&] { settings.read(config); });
  if (uses_grid_) faults.attempt([&] { settings.read(grid); });
  if (uses_grid_) faults.attempt([&] { settings.read(scan); });
  faults.attempt([&] { configure(config, grid, scan); });
  faults.raise();
}

void FastSlam::reset() {
  streams_.restart();
  index_.clear();
  particles_ = std::make_unique<ParticleSet>(static_cast<std::size_t>(config_.particles),
                                             static_cast<unsigned>(config_.threads),
                                             scans_ ? scans_->mostTiles() : 0);
  if (scans_) scans_->restart({});
  carried_.reset();
  fit_ = FitMonitor(config_.lost_nis);
  told_place_.reset();
  inputs_ = {};
  const auto revision = told_.grid_revision + 1;
  told_ = {};
  told_.grid_revision = revision;
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  told_.estimate = {Pose2(), sigma.cwiseAbs2().asDiagonal()};
  auto stream = streams_.of(Purpose::kPlace);
  particles_->redraw(told_.estimate, stream);
  bound_ = {};
  bound_.restart(told_.estimate.covariance);
}

void FastSlam::set(const Motion& motion) { append(motion, inputs_.motion); }

Status FastSlam::execute() {
  streams_.nextStep();
  told_.statistics = {};
  told_.grid_status = {};
  replaceMap();
  relocate();
  Step step;
  takeMotion(step);
  associate(step);
  takeScan(step);
  if (usesScans() && !step.hasSeen()) return carry(step);
  step.motion = std::exchange(carried_, std::nullopt);
  bool weights_are_left = true;
  if (!step.isNothing()) {
    const auto* const grid = particles_->best().grid.identity();
    propose(step);
    weights_are_left = weigh(step);
    estimate(step);
    resample(step);
    weights_are_left &= draw(step);
    judgeScan(step);
    insertScan(step);
    if (step.scan) scans_->markTaken(step.stamp);
    record(step);
    told_.grid_revision += step.is_mapped || particles_->best().grid.identity() != grid;
  }
  told_.statistics.landmarks = static_cast<int>(index_.size());
  return status(weights_are_left);
}

void FastSlam::replaceMap() {
  if (!inputs_.map) return;
  const auto map = *std::exchange(inputs_.map, std::nullopt);
  auto grid = gridOf(map);
  if (told_.grid_status.level == Status::Level::kError) return;  // all stays as it is
  index_.clear();
  for (const auto& landmark : map.landmarks) index_.append(landmark.id);
  const bool has_joint = map.joint_covariance.size() > 0;
  const double inflation = has_joint ? 1.0 : config_.load_inflation;
  particles_->replaceMaps(map.landmarks, inflation, std::move(grid));
  bound_.load(map.landmarks, inflation);
  if (!inputs_.initial_pose) inputs_.initial_pose = map.robot;
}

void FastSlam::relocate() {
  if (!inputs_.initial_pose) return;
  particles_->move(carriedIncrement());  // where they were is the end of their paths
  carried_.reset();
  told_.estimate = *std::exchange(inputs_.initial_pose, std::nullopt);
  auto drawn = told_.estimate;
  if (scans_) drawn.covariance *= 0.5;  // the other half is what a scan looks around each of them
  if (scans_) scans_->restart(drawn);
  auto stream = streams_.of(Purpose::kPlace);
  particles_->redraw(drawn, stream);
  bound_.setPose(told_.estimate.covariance);
  told_place_ = {told_.estimate.pose, told_.estimate.covariance};
  fit_.forget();
}

void FastSlam::takeMotion(Step& step) {
  step.latest = std::exchange(inputs_.motion, std::nullopt);
  if (!step.latest) return;
  step.stamp = step.latest->end;
  append(*step.latest, carried_);
  if (scans_) scans_->move(*step.latest);
}

void FastSlam::associate(Step& step) {
  if (!inputs_.observations) return;
  const auto array = *std::exchange(inputs_.observations, std::nullopt);
  step.stamp = array.stamp;
  step.sight.sensor = array.sensor_pose;
  step.sight.gate = policies_.gate;
  particle_filter::associate(array, index_, mapIsFixed(), step, told_.statistics, told_.counters);
}

void FastSlam::propose(Step& step) {
  step.resize(particles_->size());
  if (told_place_ && step.motion) told_place_ = told_place_->moved(*step.motion);
  workers_->forEach(particles_->size(), [&](std::size_t i, unsigned) { proposeFor(step, i); });
  if (step.hasSeen()) told_place_.reset();
}

void FastSlam::proposeFor(Step& step, std::size_t i) {
  const auto& particle = (*particles_)[i];
  auto& prior = step.priors[i];
  prior.mean = particle.pose;
  if (step.motion) prior = prior.moved(*step.motion);
  auto stream = streams_.of(Purpose::kPropose, i);
  if (step.scan) {
    prior.covariance = scans_->covarianceAt(prior.mean);
    step.proposals[i] =
        scans_->propose(*step.scan, particle.grid, prior, stream, step.log_factors[i]);
    return;
  }
  if (told_place_ && !step.sight.matches.empty()) prior = *told_place_;
  auto* const predictions = step.predictionsOf(i);
  step.proposals[i] = policies_.proposal->propose(policies_.model, step.sight, particle.map, prior,
                                                  stream, predictions);
  step.log_factors[i] = policies_.weighting->logFactor(predictions, step.sight.matches.size());
}

bool FastSlam::weigh(Step& step) {
  auto& weights = particles_->weights();
  fit_.judge(step.predictions, step.sight, weights.all(), told_.statistics);
  told_.counters.add("gated", static_cast<std::uint64_t>(told_.statistics.gated));
  told_.figures["recent_nis"] = fit_.recentNis();
  step.is_lost = fit_.isLost();
  step.is_doubtful = step.hasSeenLandmarks() && fit_.isDoubtful();
  told_.counters.add("doubtful", step.is_doubtful);
  if (!step.weighs()) return true;
  const bool are_left = weights.multiply(step.log_factors);
  if (!are_left) told_.counters.add("weight_underflow");
  particles_->findBest();
  return are_left;
}

void FastSlam::estimate(Step& step) {
  const auto& weights = particles_->weights();
  step.moments = momentsOf(step.proposals, weights.all());
  bound_.weigh(weights.effectiveSize(), weights.size());
  if (step.latest) bound_.move(told_.estimate.pose, *step.latest);
  if (step.scan) bound_.setPose(step.moments.covariance);  // nothing is known beyond their spread
  const auto& robot = step.moments.pose;
  const auto& [sensor, matches, gate] = step.sight;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& [slot, z] = matches[k];
    if (told_.statistics.innovations[k].used)
      bound_.observe(policies_.model, robot, sensor, particles_->best().map[slot].mean(), slot, z,
                     mapIsFixed());
  }
  told_.estimate = {robot, bound_.told(step.moments.covariance)};
}

void FastSlam::resample(Step& step) {
  const auto& weights = particles_->weights();
  auto count = weights.size();
  step.ancestors.resize(count);
  std::iota(step.ancestors.begin(), step.ancestors.end(), 0u);
  const double effective = weights.effectiveSize();
  auto& figures = told_.figures;
  figures["particles"] = static_cast<double>(count);
  figures["effective_sample_size"] = effective;
  if (effective >= config_.resampling_threshold * static_cast<double>(count)) return;

  std::vector<Pose2> poses;
  for (const auto& proposal : step.proposals) poses.push_back(proposal.mean);
  if (config_.size == "kld") {
    auto stream = streams_.of(Purpose::kResize);
    count = policies_.size.drawnFrom(poses, weights.all(), stream);
  }
  auto stream = streams_.of(Purpose::kResample);
  step.ancestors = resampledAlong(hilbertOrder(poses, step.moments), *policies_.resampling,
                                  weights.all(), count, stream);
  particles_->resample(step.ancestors);
  bound_.resample(step.ancestors);
  told_.counters.add("resampled");
  const std::set<std::uint32_t> distinct(step.ancestors.begin(), step.ancestors.end());
  figures["unique_ancestors"] = static_cast<double>(distinct.size());
}

bool FastSlam::draw(const Step& step) {
  std::vector<double> log_corrections(particles_->size());
  workers_->forEach(particles_->size(), [&](std::size_t i, unsigned lane) {
    log_corrections[i] = drawParticle(step, i, lane);
  });
  const bool weights_are_left = particles_->weights().multiply(log_corrections);
  particles_->findBest();
  return weights_are_left;
}

double FastSlam::drawParticle(const Step& step, std::size_t i, unsigned lane) {
  auto& [pose, map, grid, path] = (*particles_)[i];
  const auto ancestor = step.ancestors[i];
  const auto* const predictions = step.predictionsOf(ancestor);
  auto stream = streams_.of(Purpose::kDraw, i);
  pose = step.proposals[ancestor].sample(stream);
  const double log_correction =
      policies_.weighting->logCorrection(policies_.model, step.sight, map, step.priors[ancestor],
                                         step.proposals[ancestor], pose, predictions);
  if (!mapIsFixed()) updateMap(policies_.model, step, pose, predictions, map, lane);
  return log_correction;
}

void FastSlam::record(const Step& step) {
  particles_->record(step.stamp, step.latest ? step.latest->increment : Pose2(), step.hasSeen());
  if (mapIsFixed() || step.is_doubtful) return;
  beginAnew(step);
  for (const auto& z : step.unseen) {
    bound_.begin(policies_.model, told_.estimate.pose, step.sight.sensor, index_.size(), z);
    index_.append(z.id);
  }
  told_.statistics.added = static_cast<int>(step.unseen.size());
}

/// Where the best particle has.
void FastSlam::beginAnew(const Step& step) {
  const auto& [sensor, matches, gate] = step.sight;
  const auto& best = particles_->best();
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& [slot, z] = matches[k];
    if (told_.statistics.innovations[k].used) continue;
    const auto anew = initialized(policies_.model, best.pose, sensor, z);
    if (best.map[slot].mean() == anew.mean())
      bound_.begin(policies_.model, told_.estimate.pose, sensor, slot, z);
  }
}

Status FastSlam::status(bool weights_are_left) const {
  if (!weights_are_left)
    return Status::warning(
        "no particle can explain the observations, all weights vanished; they are made equal and "
        "the filter goes on: check the noise of the sensor in the robot file");
  if (!told_.grid_status.isOk()) return told_.grid_status;
  if (mapIsFixed() && index_.size() == 0 && particles_->best().grid.isEmpty())
    return Status::warning("there is no map to localise in; load one");
  if (fit_.isLost() || (scans_ && scans_->fit().isLost()))
    return Status::warning(
        "the latest observations are far less likely than they should be: the pose may be lost; "
        "set an initial pose");
  return Status::ok();
}

}  // namespace slam::particle_filter
