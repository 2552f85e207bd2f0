// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/filter/fast_slam.hpp"

#include <numeric>
#include <set>
#include <utility>

#include "slam_core/particle_filter/particles/mixture.hpp"

namespace slam::particle_filter {
namespace {

using Purpose = RandomStreams::Purpose;

Status statusOfWeights(bool are_left) {
  if (are_left) return Status::ok();
  return Status::alarm(
      "no particle can explain the observations, all weights vanished; they are made equal and "
      "the filter goes on: check the noise of the sensor in the robot file");
}

}  // namespace

/// After Montemerlo 2003 and Grisetti, Stachniss, Burgard 2007, alg. 1, but that particles are
/// weighed and resampled before their poses are drawn (Pitt, Shephard 1999).
Status FastSlam::execute() {
  execution_.streams.nextStep();
  account_.statistics = {};
  account_.statistics.gate_probability = config_.gate_probability;
  const auto replaced = replaceMap();
  relocate();
  const auto step = takeInputs();
  if (step.update == nullptr) return summary({carry(step), replaced});
  const auto drafts = propose(step);
  const auto weighed = weigh(drafts, *step.update);
  const auto moments = estimate(drafts, step);
  const auto ancestors = resample(drafts, moments);
  const auto drawn = draw(drafts, ancestors, *step.update);
  const auto learnt = learn(ancestors, step);
  return summary({weighed, drawn, learnt, replaced});
}

FastSlam::Step FastSlam::takeInputs() {
  Step step;
  step.latest = std::exchange(inputs_.motion, std::nullopt);
  const auto observations = std::exchange(inputs_.observations, std::nullopt);
  const auto scan = std::exchange(inputs_.scan, std::nullopt);
  is_corrected_ = false;
  if (step.latest) {
    step.stamp = step.latest->end;
    belief_.carried = belief_.carried ? joined(*belief_.carried, *step.latest) : step.latest;
    landmarks_.move(*step.latest);
    if (scans_) scans_->move(*step.latest);
  }
  if (observations) step.stamp = observations->stamp;
  if (scan) step.stamp = scan->stamp;
  step.has_seen = landmarks_.take(observations, account_);
  if (step.has_seen || (!scans_ && step.latest)) step.update = &landmarks_;
  if (!scans_ || !scan) return step;
  step.is_followed = true;
  if (scans_->take(*scan, best(), best().followed * carriedIncrement(), account_)) {
    step.update = &*scans_;
    step.has_seen = true;
  }
  is_corrected_ = hasCorrected(scans_->doubt());
  correct(scans_->correction(), step);
  return step;
}

void FastSlam::correct(const ScanCorrection& correction, Step& step) {
  const auto carried = belief_.carried.value_or(Motion());
  for (std::size_t i = 0; i < particles_->size(); ++i) {
    auto& particle = (*particles_)[i];
    const Pose2 strayed = particle.followed.between(particle.pose);
    particle.pose = particle.followed * corrected(strayed, carried.increment, correction);
    particle.followed = particle.pose;
  }
  belief_.carried = corrected(carried, correction);
  if (step.latest) step.latest = corrected(*step.latest, correction);
}

/// Propagates the reported pose and its covariance only; the motion is applied to the particles
/// later.
Status FastSlam::carry(const Step& step) {
  if (!scans_) return Status::ok();
  auto& [pose, covariance] = belief_.estimate;
  if (step.latest) {
    const auto& [increment, Q] = std::tie(step.latest->increment, step.latest->covariance);
    belief_.bound.move(pose, *step.latest);
    Eigen::Matrix3d J_pose, J_u;
    pose = pose.compose(increment, &J_pose, &J_u);
    covariance = J_pose * covariance * J_pose.transpose() + J_u * Q * J_u.transpose();
  }
  if (step.is_followed) {
    scans_->inform(belief_.estimate, *particles_, belief_.bound);
    covariance = belief_.bound.told(covariance);
  }
  if (step.stamp != Stamp())
    record(*particles_, step.stamp, step.latest ? step.latest->increment : Pose2(), false);
  return Status::ok();
}

Drafts FastSlam::propose(const Step& step) {
  const auto motion = std::exchange(belief_.carried, std::nullopt);
  auto& place = belief_.told_place;
  if (place && motion) place = place->moved(*motion);
  auto drafts = step.update->propose(*particles_, motion, belief_, execution_);
  for (std::size_t i = 0; scans_ && motion && i < particles_->size(); ++i)
    (*particles_)[i].followed = (*particles_)[i].followed * motion->increment;
  if (step.has_seen) place.reset();
  return drafts;
}

Status FastSlam::weigh(const Drafts& drafts, SensorUpdate& update) {
  update.judge(particles_->weights(), account_);
  const bool are_left = particles_->weigh(drafts.log_factors);
  if (!are_left) account_.counters.add("weight_underflow");
  return statusOfWeights(are_left);
}

PoseEstimate FastSlam::estimate(const Drafts& drafts, const Step& step) {
  const auto& weights = particles_->weights();
  auto& [estimate, bound, told_place, carried] = belief_;
  const auto moments = momentsOf(drafts.proposals, weights.all());
  bound.genealogy().weigh(weights.effectiveSize(), weights.size());
  if (step.latest) bound.move(estimate.pose, *step.latest);
  step.update->inform(moments, *particles_, bound);
  estimate = {moments.pose, bound.told(moments.covariance)};
  return moments;
}

Ancestors FastSlam::resample(const Drafts& drafts, const PoseEstimate& moments) {
  const auto& weights = particles_->weights();
  auto& figures = account_.figures;
  figures["particles"] = static_cast<double>(weights.size());
  figures["effective_sample_size"] = weights.effectiveSize();
  if (!resampler_.isDue(weights)) {
    Ancestors themselves(weights.size());
    std::iota(themselves.begin(), themselves.end(), 0u);
    return themselves;
  }
  const auto ancestors = resampler_.draw(drafts.proposals, weights, moments, execution_.streams);
  particles_->resample(ancestors);
  belief_.bound.genealogy().resample(ancestors);
  account_.counters.add("resampled");
  const std::set<std::uint32_t> distinct(ancestors.begin(), ancestors.end());
  figures["unique_ancestors"] = static_cast<double>(distinct.size());
  return ancestors;
}

Status FastSlam::draw(const Drafts& drafts, const Ancestors& ancestors,
                      const SensorUpdate& update) {
  std::vector<double> log_corrections(particles_->size());
  execution_.workers->forEach(particles_->size(), [&](std::size_t i, unsigned) {
    auto& particle = (*particles_)[i];
    auto stream = execution_.streams.of(Purpose::kDraw, i);
    particle.pose = drafts.proposals[ancestors[i]].sample(stream);
    if (&update != &landmarks_) particle.followed = particle.pose;
    log_corrections[i] = update.logCorrection(drafts, ancestors[i], particle);
  });
  return statusOfWeights(particles_->weigh(log_corrections));
}

Status FastSlam::learn(const Ancestors& ancestors, const Step& step) {
  const auto lesson = step.update->learn(*particles_, ancestors, belief_, execution_, account_);
  record(*particles_, step.stamp, step.latest ? step.latest->increment : Pose2(), step.has_seen);
  const auto* const grid = best().grid.identity();
  const bool is_other = grid != std::exchange(shown_grid_.identity, grid);
  shown_grid_.revision += lesson.changes_grids || is_other;
  return lesson.status;
}

/// The most urgent status of the steps and of the whole; of equally urgent ones the first.
Status FastSlam::summary(std::initializer_list<Status> of_steps) {
  account_.statistics.landmarks = static_cast<int>(landmarksInMap());
  auto told = Status::ok();
  for (const auto& status : of_steps) told = moreUrgent(status, told);
  return moreUrgent(onTheWhole(), told);
}

Status FastSlam::onTheWhole() const {
  if (config_.mapIsFixed() && best().map.size() == 0 && best().grid.isEmpty())
    return Status::warning("there is no map to localise in; load one");
  if (landmarks_.isLost())
    return Status::alarm(
        "the latest observations are far less likely than they should be: the pose may be lost; "
        "set an initial pose");
  return scans_ ? scans_->status() : Status::ok();
}

void FastSlam::saveState(ArchiveWriter& archive) const { archive(*this); }

void FastSlam::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::particle_filter
