// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/fast_slam.hpp"

#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/particle_filter/hilbert_order.hpp"
#include "slam_core/particle_filter/kld_size.hpp"
#include "slam_core/particle_filter/landmark_filter.hpp"
#include "slam_core/particle_filter/mixture.hpp"
#include "slam_core/particle_filter/parallel.hpp"

namespace slam::particle_filter {
namespace {

const Registrar<Backend, FastSlam> kRegistrar("pf");
const SectionRegistrar<PfConfig> kSectionRegistrar;

KldSize kldSize(const PfConfig& config) {
  KldSize::Limits limits;
  limits.min = static_cast<std::size_t>(config.min_particles);
  limits.max = static_cast<std::size_t>(config.max_particles);
  limits.error = config.kld_error;
  limits.quantile = config.kld_quantile;
  limits.bin_position = config.kld_bin_position;
  limits.bin_heading = config.kld_bin_heading;
  return KldSize(limits);
}

}  // namespace

/// What one execute() works with.
struct FastSlam::Step {
  Stamp stamp;
  std::optional<Motion> motion;
  Sight sight;
  std::vector<LandmarkObservation> unseen;  ///< of landmarks that are in no map yet

  std::vector<PoseGaussian> priors, proposals;  ///< one for each particle
  std::vector<double> log_factors;              ///< one for each particle
  std::vector<Prediction> predictions;          ///< all of particle 0, then of particle 1, ...
  bool is_lost = false;
  std::vector<std::uint32_t> ancestors;  ///< whose prior, proposal and predictions a particle has

  bool isNothing() const { return !motion && sight.matches.empty() && unseen.empty(); }
  Prediction* predictionsOf(std::size_t i) { return predictions.data() + i * sight.matches.size(); }
  const Prediction* predictionsOf(std::size_t i) const {
    return predictions.data() + i * sight.matches.size();
  }
};

void FastSlam::configure(const PfConfig& config) {
  validatePf(config);
  config_ = config;
  // the quantile of the chi-square distribution with two degrees of freedom has a closed form
  gate_ = -2.0 * std::log(1.0 - config.gate_probability);
  proposal_ = makeProposal(config.proposal);
  weighting_ = makeWeighting(config.weighting);
  resampling_ = makeResampling(config.resampling);
  reset();
}

void FastSlam::configure(Settings& settings) { configure(settings.read<PfConfig>()); }

void FastSlam::reset() {
  step_ = 0;
  index_.clear();
  particles_ = std::make_unique<ParticleSet>(static_cast<std::size_t>(config_.particles),
                                             static_cast<unsigned>(config_.threads));
  const double position = config_.initial_sigma_position, heading = config_.initial_sigma_heading;
  const Eigen::Vector3d sigma(position, position, heading);
  estimate_ = {Pose2(), sigma.cwiseAbs2().asDiagonal()};
  auto stream = random(Purpose::kPlace);
  particles_->redraw(estimate_, stream);
  fit_ = FitMonitor(config_.lost_nis);
  statistics_ = {};
  counters_.clear();
  figures_.clear();
  map_.reset();
  initial_pose_.reset();
  motion_.reset();
  observations_.reset();
}

RandomStream FastSlam::random(Purpose purpose, std::size_t particle) const {
  constexpr unsigned kBitsOfParticle = 28;
  return RandomStream(seed_, step_,
                      static_cast<std::uint32_t>(purpose) << kBitsOfParticle |
                          static_cast<std::uint32_t>(particle));
}

void FastSlam::set(const Motion& motion) {
  if (!motion_) {
    motion_ = motion;
    return;
  }
  Eigen::Matrix3d J_before, J_u;
  motion_->increment = motion_->increment.compose(motion.increment, &J_before, &J_u);
  motion_->covariance = J_before * motion_->covariance * J_before.transpose() +
                        J_u * motion.covariance * J_u.transpose();
  motion_->end = motion.end;
}

Status FastSlam::execute() {
  ++step_;
  statistics_ = {};
  replaceMap();
  relocate();
  Step step;
  associate(step);
  bool weights_are_left = true;
  if (!step.isNothing()) {
    propose(step);
    weights_are_left = weigh(step);
    estimate(step);
    resample(step);
    weights_are_left &= draw(step);
  }
  statistics_.landmarks = static_cast<int>(index_.size());
  return status(step, weights_are_left);
}

void FastSlam::replaceMap() {
  if (!map_) return;
  index_.clear();
  for (const auto& landmark : map_->landmarks) index_.append(landmark.id);
  const bool has_joint = map_->joint_covariance.size() > 0;
  particles_->replaceMaps(map_->landmarks, has_joint ? 1.0 : config_.load_inflation);
  if (!initial_pose_) initial_pose_ = map_->robot;
  map_.reset();
}

void FastSlam::relocate() {
  if (!initial_pose_) return;
  auto stream = random(Purpose::kPlace);
  particles_->redraw(*initial_pose_, stream);
  estimate_ = *initial_pose_;
  fit_.forget();
  initial_pose_.reset();
}

void FastSlam::associate(Step& step) {
  step.motion = std::exchange(motion_, std::nullopt);
  if (step.motion) step.stamp = step.motion->end;
  if (!observations_) return;
  const auto array = *std::exchange(observations_, std::nullopt);
  step.stamp = array.stamp;
  step.sight.sensor = array.sensor_pose;
  step.sight.gate = gate_;
  std::set<LandmarkId> seen;
  for (const auto& z : array.observations) {
    if (z.id == kUnknownId) {
      ++statistics_.unknown;
      counters_.add("unknown_id");
    } else if (!seen.insert(z.id).second) {
      counters_.add("duplicate");
    } else if (const auto slot = index_.find(z.id)) {
      step.sight.matches.push_back({*slot, z});
    } else if (config_.mode == "localization") {
      ++statistics_.unknown;
      counters_.add("not_in_map");
    } else {
      step.unseen.push_back(z);
    }
  }
}

void FastSlam::propose(Step& step) {
  const auto count = particles_->size();
  step.priors.resize(count);
  step.proposals.resize(count);
  step.log_factors.resize(count);
  step.predictions.resize(count * step.sight.matches.size());
  forEachInParallel(count, static_cast<unsigned>(config_.threads), [&](std::size_t i, unsigned) {
    const auto& particle = (*particles_)[i];
    auto& prior = step.priors[i];
    prior.mean = particle.pose;
    if (step.motion) {
      Eigen::Matrix3d J_u;
      prior.mean = particle.pose.compose(step.motion->increment, nullptr, &J_u);
      prior.covariance = J_u * step.motion->covariance * J_u.transpose();
    }
    auto stream = random(Purpose::kPropose, i);
    auto* const predictions = step.predictionsOf(i);
    step.proposals[i] =
        proposal_->propose(model_, step.sight, particle.map, prior, stream, predictions);
    step.log_factors[i] = weighting_->logFactor(predictions, step.sight.matches.size());
  });
}

bool FastSlam::weigh(Step& step) {
  if (step.sight.matches.empty()) return true;
  auto& weights = particles_->weights();
  fit_.judge(step.predictions, step.sight, weights.all(), statistics_);
  counters_.add("gated", static_cast<std::uint64_t>(statistics_.gated));
  step.is_lost = fit_.isLost();
  const bool are_left = weights.multiply(step.log_factors);
  if (!are_left) counters_.add("weight_underflow");
  particles_->findBest();
  return are_left;
}

void FastSlam::estimate(const Step& step) {
  estimate_ = momentsOf(step.proposals, particles_->weights().all());
}

void FastSlam::resample(Step& step) {
  const auto& weights = particles_->weights();
  auto count = weights.size();
  step.ancestors.resize(count);
  std::iota(step.ancestors.begin(), step.ancestors.end(), 0u);
  const double effective = weights.effectiveSize();
  figures_["particles"] = static_cast<double>(count);
  figures_["effective_sample_size"] = effective;
  if (effective >= config_.resampling_threshold * static_cast<double>(count)) return;

  std::vector<Pose2> poses;
  for (const auto& proposal : step.proposals) poses.push_back(proposal.mean);
  if (config_.size == "kld") {
    auto stream = random(Purpose::kResize);
    count = kldSize(config_).drawnFrom(poses, weights.all(), stream);
  }
  auto stream = random(Purpose::kResample);
  step.ancestors =
      resampledAlong(hilbertOrder(poses, estimate_), *resampling_, weights.all(), count, stream);
  particles_->resample(step.ancestors);
  counters_.add("resampled");
  const std::set<std::uint32_t> distinct(step.ancestors.begin(), step.ancestors.end());
  figures_["unique_ancestors"] = static_cast<double>(distinct.size());
}

bool FastSlam::draw(const Step& step) {
  std::vector<double> log_corrections(particles_->size());
  forEachInParallel(
      particles_->size(), static_cast<unsigned>(config_.threads),
      [&](std::size_t i, unsigned lane) { log_corrections[i] = drawParticle(step, i, lane); });
  for (std::size_t i = 0; i < particles_->size(); ++i) {
    auto& particle = (*particles_)[i];
    particle.path.append({step.stamp, particle.pose});
  }
  for (const auto& z : step.unseen) index_.append(z.id);
  statistics_.added = static_cast<int>(step.unseen.size());
  const bool weights_are_left = particles_->weights().multiply(log_corrections);
  particles_->findBest();
  return weights_are_left;
}

double FastSlam::drawParticle(const Step& step, std::size_t i, unsigned lane) {
  auto& [pose, map, path] = (*particles_)[i];
  const auto& sight = step.sight;
  const auto ancestor = step.ancestors[i];
  const auto* const predictions = step.predictionsOf(ancestor);
  auto stream = random(Purpose::kDraw, i);
  pose = step.proposals[ancestor].sample(stream);
  const double log_correction = weighting_->logCorrection(
      model_, sight, map, step.priors[ancestor], step.proposals[ancestor], pose, predictions);
  if (config_.mode == "localization") return log_correction;
  for (std::size_t k = 0; k < sight.matches.size(); ++k) {
    const auto& [slot, z] = sight.matches[k];
    const bool fits = !predictions[k].gated;
    if (!fits && step.is_lost) continue;  // it is the robot that is elsewhere, not the landmarks
    takeSighting(model_, pose, sight.sensor, z, fits, map.edit(slot, lane));
  }
  for (const auto& z : step.unseen) map.push_back(initialized(model_, pose, sight.sensor, z), lane);
  return log_correction;
}

Status FastSlam::status(const Step& step, bool weights_are_left) const {
  if (!weights_are_left)
    return Status::warning(
        "no particle can explain the observations, all weights vanished; they are made equal and "
        "the filter goes on: check the noise of the sensor in the robot file");
  if (config_.mode == "localization" && index_.size() == 0)
    return Status::warning("there is no map to localise in; load one");
  if (step.is_lost)
    return Status::warning(
        "the latest observations are far less likely than they should be: the pose may be lost; "
        "set an initial pose");
  return Status::ok();
}

}  // namespace slam::particle_filter
