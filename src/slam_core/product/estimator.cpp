// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/estimator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/nearest_name.hpp"
#include "slam_core/product/map_choice.hpp"

namespace slam {
namespace {

bool isInvalid(const LaserBeam& beam) {
  return !std::isfinite(beam.bearing) || !std::isfinite(beam.range) || beam.range <= 0.0f;
}

}  // namespace

void Estimator::configure(Settings& settings, std::unique_ptr<Backend> backend) {
  backend_ = std::move(backend);
  start_map_.reset();
  expects_observations_ = true;
  FaultCollector faults;
  faults.attempt([&] { backend_->seed(settings.read<ProductConfig>().seed); });
  faults.attempt([&] { chooseMap(settings.read<ProductConfig>(), *backend_); });
  faults.attempt([&] { backend_->configure(settings); });
  faults.attempt([&] { consistency_config_ = settings.read<ConsistencyConfig>(); });
  faults.attempt([&] { sensor_ = settings.read<LandmarkSensorConfig>(); });
  faults.attempt([&] { frames_ = settings.read<FramesConfig>(); });
  faults.attempt([&] {
    source_timeout_ = durationFromSeconds(settings.read<ProductConfig>().source_timeout);
  });
  faults.raise();
  reset();
}

Status Estimator::resetBackend() {
  backend_->reset();
  consistency_ = ConsistencyMonitor(consistency_config_);
  return start_map_ ? set(*start_map_) : Status::ok();
}

void Estimator::reset() {
  fault_ = resetBackend().message;
  TriggerCollator::Limits limits;
  limits.source_timeout = source_timeout_;
  collator_ = TriggerCollator(usesScans() ? 2 : 1, limits);
  if (!expects_observations_) collator_.expectNothing(kObservations);
  gap_.reset();
  last_motion_.reset();
  report_.reset();
  moved_frame_.clear();
  paused_ = false;
  counters_.clear();
}

Status Estimator::set(const PoseEstimate& initial_pose) {
  backend_->set(initial_pose);
  const auto status = backend_->execute();
  consistency_.add(backend_->statistics());
  return status;
}

/// What was judged until then was of another map.
Status Estimator::set(const MapState& map) {
  backend_->set(map);
  const auto status = backend_->execute();
  if (status.level != Status::Level::kError) consistency_ = ConsistencyMonitor(consistency_config_);
  return status;
}

Status Estimator::startWith(MapState map) {
  start_map_ = std::move(map);
  return resetBackend();
}

void Estimator::expectNoObservations() {
  expects_observations_ = false;
  collator_.expectNothing(kObservations);
}

void Estimator::set(Motion motion) {
  frames_.complete(motion.odometry_frame, motion.base_frame);
  warnOfBaseFrame(motion.base_frame);
  const auto fault = faultOf(motion);
  if (fault.empty()) {
    if (gap_.bridge(motion)) counters_.add("bridged");
    collator_.push(std::move(motion));
    return;
  }
  counters_.add("invalid_motion");
  fault_ = fault + "; it is left out";
}

void Estimator::warnOfBaseFrame(const std::string& moved) {
  if (moved == std::exchange(moved_frame_, moved) || moved == frames_.base) return;
  fault_ = "odometry moves '" + moved + "', while the sensors' poses are looked up in '" +
           frames_.base + "': set frames.base to '" + moved + "' in the robot file";
}

void Estimator::set(LandmarkObservationArray array) {
  completeCovariances(sensor_, array);
  auto& all = array.observations;
  if (!array.sensor_pose.isFinite()) {
    counters_.add("invalid_observation", all.size());
    fault_ = "observations with a sensor pose that holds a value that is not a number are left out";
    all.clear();
  }
  const auto is_invalid = [this](const LandmarkObservation& observation) {
    const auto fault = faultOf(observation);
    if (fault.empty()) return false;
    counters_.add("invalid_observation");
    fault_ = fault + "; it is left out";
    return true;
  };
  all.erase(std::remove_if(all.begin(), all.end(), is_invalid), all.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto stamp = array.stamp;
  const auto sequence = array.sequence;
  collator_.push(kObservations, stamp, sequence, std::move(array));
}

void Estimator::set(LaserScan scan) {
  if (!usesScans()) return;
  auto& beams = scan.beams;
  if (!scan.sensor_pose.isFinite() || std::any_of(beams.begin(), beams.end(), isInvalid)) {
    counters_.add("invalid_scan");
    fault_ =
        "a scan whose sensor pose or beams hold values that are not numbers, or a range that "
        "is not above 0, is taken as empty";
    beams.clear();
  }
  const auto stamp = scan.stamp;
  const auto sequence = scan.sequence;
  collator_.push(kScans, stamp, sequence, std::move(scan));
}

Status Estimator::execute() {
  report_.reset();
  auto step = collator_.next();
  Status status = fault_.empty() ? Status::ok() : Status::warning(std::exchange(fault_, ""));
  if (!step) return status;
  if (step->restart) {
    if (const auto start = resetBackend(); !start.isOk()) status = start;
    last_motion_.reset();
  }
  for (const auto& motion : step->motions) backend_->set(motion);
  if (!step->motions.empty()) last_motion_ = step->motions.back();
  if (step->trigger && paused_)
    counters_.add("paused");
  else if (step->trigger)
    takeTrigger(*step->trigger);
  const auto step_status = backend_->execute();
  const auto consistency_status = watchConsistency();
  for (const auto& other : {consistency_status, step_status})
    if (!other.isOk()) status = other;
  reportStep(*step);
  return status;
}

void Estimator::takeTrigger(const Trigger& trigger) {
  std::visit([this](const auto& input) { backend_->set(input); }, trigger);
}

Status Estimator::watchConsistency() {
  const auto before = consistency_.overconfident();
  consistency_.add(backend_->statistics());
  const auto now = consistency_.overconfident();
  return now && now != before ? Status::warning(consistency_.finding()) : Status::ok();
}

void Estimator::reportStep(const TriggerCollator::Step& step) {
  StepReport report;
  report.stamp = step.stamp;
  if (step.trigger)
    report.trigger = std::holds_alternative<LaserScan>(*step.trigger) ? StepTrigger::kScan
                                                                      : StepTrigger::kObservations;
  report.pose = backend_->pose();
  // at the very start of motion none has been applied yet
  if (const auto* motion = last_motion_ ? &*last_motion_ : collator_.pending()) {
    report.odometry_pose = last_motion_ ? motion->odometry_end : motion->odometry_start;
    report.odometry_frame = motion->odometry_frame;
    report.base_frame = motion->base_frame;
  }
  report.statistics = backend_->statistics();
  report.restarted = step.restart;
  report_ = std::move(report);
}

std::string Estimator::starving() const {
  std::vector<std::string> names;
  std::optional<Stamp> since;
  for (const auto source : {kObservations, kScans}) {
    if (source == kScans && !usesScans()) continue;
    const auto stamp = collator_.starvedSince(source, kPatience);
    if (!stamp) continue;
    names.emplace_back(source == kScans ? "scans" : "observations");
    since = since ? std::min(*since, *stamp) : *stamp;
  }
  if (!since) return "";
  return fmt::format("{} since {:.1f} wait for motion", join(names, " and "),
                     seconds(*since - Stamp()));
}

Counters Estimator::counters() const {
  Counters all = counters_;
  for (const auto* part : {&collator_.counters(), &backend_->counters()})
    for (const auto& [reason, count] : part->all()) all.add(reason, count);
  return all;
}

std::uint64_t Estimator::dropped() const {
  const auto& collated = collator_.counters();
  return collated["late"] + collated["lost"] + collated["overflow"] + collated["stamp_jump"] +
         counters_["invalid_motion"];
}

}  // namespace slam
