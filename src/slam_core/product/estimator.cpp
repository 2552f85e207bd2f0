// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/without_covariance.hpp"
#include "slam_core/product/calibration_check.hpp"

namespace slam {

namespace {

constexpr const char* kBeforeCheckpoint =
    "the stamps went back behind those of the checkpoint: time begins anew with its map";

/// A warning, or that all is well where the sentence is empty.
Status statusOf(const std::string& fault) {
  return fault.empty() ? Status::ok() : Status::warning(fault);
}

/// A policy that goes by places gives landmarks ids of its own.
relocalisation::LocalLandmarks::Ids idsOf(Settings& settings) {
  using Ids = relocalisation::LocalLandmarks::Ids;
  const bool are_known = settings.read<ProductConfig>().association == "known_ids";
  return are_known ? Ids::kKnown : Ids::kIgnored;
}

}  // namespace

void Estimator::use(std::unique_ptr<Backend> backend) { backend_ = std::move(backend); }

void Estimator::adaptTo(const ProductConfig& product) {
  has_odometry_ = product.odometry != "none";
  further_ = detectorPlacesOf(product);
  further_.erase(std::remove_if(further_.begin(), further_.end(),
                                [](const auto& place) { return place.prefix().empty(); }),
                 further_.end());
  expected_ = ExpectedLandmarks(product);
  chooseMap(product, *backend_);
  capabilities_ = capabilitiesOf(*backend_);
  auto* chooser = capabilities_.find<AssociationChooser>();
  if (chooser != nullptr) chooser->useAssociation(product.association);
  if (chooser == nullptr && product.association != "known_ids")
    throw ConfigError("association: the back-end '" + product.backend +
                      "' associates no observations by '" + product.association +
                      "'; leave the key out, or choose another back-end");
}

Ports Estimator::usedPorts() const {
  Ports used;
  for (const auto& input : portsOf(*backend_).inputs()) {
    if (!has_odometry_ && !input.is_mandatory && input.time == TimeRole::kCarrier) continue;
    used.add(input);
    if (input.kind == kindOf<LandmarkObservationArray>()) addFurther(input, used);
  }
  return used;
}

/// Observations of one stamp come in the order of their inputs.
void Estimator::addFurther(const InputPort& observations, Ports& used) const {
  for (const auto& place : further_) {
    auto& input = used.add(observations);
    input.name = place.observations();
    input.sentence = place.description();
  }
}

void Estimator::configure(Settings& settings) {
  start_map_.reset();
  start_session_.reset();
  FaultCollector faults;
  faults.attempt([&] { backend_->seed(settings.read<ProductConfig>().seed); });
  faults.attempt([&] { adaptTo(settings.read<ProductConfig>()); });
  ports_ = usedPorts();
  const auto& inputs = ports_.inputs();
  const auto carrier = std::find_if(inputs.begin(), inputs.end(), [](const auto& input) {
    return input.time == TimeRole::kCarrier;
  });
  carrier_ = carrier == inputs.end() ? nullptr : &*carrier;
  capabilities_ = capabilitiesOf(*backend_);
  fragment_.use(capabilities_.find<SessionMerger>());
  capabilities_.offer<MapFragment>(fragment_);
  faults.attempt([&] { backend_->configure(settings); });
  faults.attempt(
      [&] { checkCalibration(settings.read<ProductConfig>(), capabilities_, settings); });
  faults.attempt([&] { consistency_config_ = settings.read<ConsistencyConfig>(); });
  faults.attempt([&] { events_config_ = settings.read<EventsConfig>(); });
  faults.attempt([&] { frames_ = settings.read<FramesConfig>(); });
  faults.attempt([&] { relocaliser_.configure(settings, capabilities_, idsOf(settings)); });
  faults.attempt([&] { fragment_.goBy(idsOf(settings)); });
  faults.attempt([&] { intake_.configure(settings, ports_, takesLines()); });
  faults.raise();
  reset();
}

bool Estimator::takesLines() const {
  const auto* mapper = capabilities_.find<LandmarkMapper>();
  return mapper != nullptr && mapper->takesLines();
}

void Estimator::describe(Ports& ports) {
  const auto of_backend = usedPorts();
  for (const auto& input : of_backend.inputs()) {
    auto& mine = ports.add(input);
    mine.set = [this, name = input.name, kind = input.kind](const void* value) {
      intake_.take(name, kind, value);
    };
  }
  ports.makes<FilterPose>("pose", pose_);
}

Status Estimator::resetBackend() {
  backend_->reset();
  intake_.knowOnly({});
  consistency_ = ConsistencyMonitor(consistency_config_);
  events_ = EventWatch(events_config_);
  relocaliser_.reset();
  fragment_.reset();
  noise_ = NoiseAdaptation();
  dead_reckoning_.correct();
  doubt_.restart();
  if (start_session_) return set(*start_session_);
  return start_map_ ? set(*start_map_) : Status::ok();
}

void goOnLive(Estimator& estimator, Interruption interruption) {
  resume(estimator.intake_, interruption);
  estimator.saved_map_.emplace(estimator.capabilities_);
}

/// With the map of a checkpoint that no step has followed yet.
Status Estimator::restart() {
  const auto saved = std::exchange(saved_map_, std::nullopt);
  const auto status = resetBackend();
  if (!saved || saved->isEmpty()) return status;
  const auto kept = saved->session() ? set(*saved->session()) : set(saved->map());
  if (kept.level == Status::Level::kError) return kept;
  return together(together(Status::alarm(kBeforeCheckpoint), kept), saved->doubt(relocaliser_));
}

/// With what tells first where the robot went since a checkpoint.
Status Estimator::judgePause() {
  const auto is_bridged = takeContinuity(intake_);
  if (is_bridged.value_or(true)) return Status::ok();
  fragment_.end();
  return SavedMap(capabilities_).doubt(relocaliser_);
}

void Estimator::reset() {
  fault_ = resetBackend().message;
  saved_map_.reset();
  intake_.reset();
  last_motion_.reset();
  report_.reset();
  pose_.reset();
  paused_ = false;
  counters_.clear();
}

Status Estimator::execute() {
  report_.reset();
  pose_.reset();
  const auto step = intake_.next();
  auto fault = std::exchange(fault_, "");
  if (const auto of_input = intake_.takeFault(); !of_input.empty()) fault = of_input;
  if (!step) return statusOf(fault);
  const auto start = step->restart ? restart() : judgePause();
  saved_map_.reset();
  if (step->restart) last_motion_.reset();
  give(*step);
  if (const auto of_step = intake_.takeFault(); fault.empty()) fault = of_step;
  auto status = start.isOk() ? statusOf(fault) : start;
  const bool was_lost = isLostByBackend();
  const auto step_status = backend_->execute();
  if (const auto of_state = faultOfState(); !of_state.isOk()) return of_state;
  learnMerged();
  judgeCorrection(step->stamp);
  const auto consistency_status = watchConsistency();
  judgeWay(was_lost);
  const auto place_status = relocate(step->stamp);
  const auto fragment_status =
      fragment_.judge({isLost(), isTested(relocaliser_), backend_->pose().pose, step->stamp});
  // what the monitor finds is said once only
  for (const auto& other :
       {step_status, place_status, fragment_status, consistency_status, watchCalibration()})
    status = moreUrgent(status, other);
  reportStep(*step);
  return status;
}

std::optional<CalibrationEstimate> Estimator::calibration() const {
  const auto* calibrator = capabilities_.find<Calibrator>();
  return calibrator == nullptr ? std::nullopt : calibrator->calibration();
}

/// The back-end corrects by itself what it is given. Where it estimates the parameters of the
/// wheels, its covariance has what they do to long ways.
void Estimator::give(const Intake::Step& step) {
  const auto known = calibration();
  for (const auto& measured : step.motions) {
    const auto scaled = noise_.scaled(measured);
    carrier_->set(&scaled);
    fragment_.predict(scaled);
    const auto reported = known ? calibrated(measured, known->parameters) : measured;
    const auto motion = noise_.scaled(reported);
    if (!known) dead_reckoning_.predict(motion);
    if (consistency_config_.adapt) doubt_.predict(reported);
    events_.predict(motion);
    relocaliser_.predict(reported);
  }
  if (!step.motions.empty()) last_motion_ = step.motions.back();
  if (!step.trigger) return;
  if (paused_) {
    counters_.add("paused");
    return;
  }
  const auto trigger = scaled(*step.trigger);
  fragment_.see(trigger.port->kind, trigger.value.get());
  if (isAdmitted(*step.trigger)) {
    intake_.admit(*step.trigger);
    give(trigger);
  }
}

/// The same with the noise that the innovations have shown.
Intake::Trigger Estimator::scaled(const Intake::Trigger& trigger) const {
  if (trigger.port->kind != kindOf<LandmarkObservationArray>() || noise_.isNeutral())
    return trigger;
  const auto& array = *static_cast<const LandmarkObservationArray*>(trigger.value.get());
  return {trigger.port, std::make_shared<LandmarkObservationArray>(noise_.scaled(array))};
}

void Estimator::give(const Intake::Trigger& trigger) {
  const bool has_landmarks = trigger.port->kind == kindOf<LandmarkObservationArray>();
  if (!has_landmarks && capabilities_.find<CorrectionReporter>() == nullptr)
    dead_reckoning_.correct();
  trigger.port->set(trigger.value.get());
}

/// The landmarks of a session that the last step has merged are known from now on.
void Estimator::learnMerged() {
  const auto* reporter = capabilities_.find<EventReporter>();
  const auto* mapper = capabilities_.find<LandmarkMapper>();
  const auto events = reporter == nullptr ? std::vector<Event>() : reporter->events();
  const auto is_merge = [](const Event& event) { return event.kind == Event::Kind::kMerged; };
  if (mapper == nullptr || std::none_of(events.begin(), events.end(), is_merge)) return;
  const auto landmarks = mapper->landmarks();
  intake_.knowOnly(landmarks);
  dead_reckoning_.know(landmarks);
  searchBy(relocaliser_, landmarks);
}

void Estimator::judgeCorrection(Stamp stamp) {
  const auto* reporter = capabilities_.find<CorrectionReporter>();
  const auto first_seen = reporter == nullptr ? std::nullopt : reporter->correctedBy();
  if (first_seen) dead_reckoning_.correct(*first_seen, stamp, backend_->pose().pose);
}

bool Estimator::isAdmitted(const Intake::Trigger& trigger) {
  const auto* const value = trigger.value.get();
  if (trigger.port->kind == kindOf<LandmarkObservationArray>()) {
    const auto& array = *static_cast<const LandmarkObservationArray*>(value);
    const auto* calibrator = capabilities_.find<Calibrator>();
    const bool calibrates = calibrator != nullptr && calibrator->calibration();
    const auto corrected = calibrates ? calibrator->corrected(array) : array;
    if (consistency_config_.adapt) doubt_.see(corrected);
    return relocaliser_.see(corrected);
  }
  if (trigger.port->kind == kindOf<LaserScan>())
    return relocaliser_.see(*static_cast<const LaserScan*>(value));
  return true;
}

Status Estimator::relocate(Stamp stamp) {
  const auto place = relocaliser_.judge(backend_->pose(), stamp);
  if (!place) return relocaliser_.status();
  backend_->set(*place);
  events_.relocate("the place was recognised in the map");
  dead_reckoning_.correct();
  consistency_ = ConsistencyMonitor(consistency_config_);
  const auto status = backend_->execute();
  doubt_.relocate(backend_->pose().pose);
  return status;
}

Status Estimator::faultOfState() {
  const auto estimate = backend_->pose();
  if (estimate.pose.isFinite() && estimate.covariance.allFinite()) return Status::ok();
  counters_.add("not_finite_pose");
  return Status::error(
      "the back-end's pose is not a finite number, so that it is neither published nor written: "
      "reset the back-end, and report the input that led to it");
}

UpdateStatistics Estimator::statistics() const {
  const auto* mapper = capabilities_.find<LandmarkMapper>();
  return mapper == nullptr ? UpdateStatistics() : mapper->statistics();
}

Status Estimator::watchCalibration() const {
  const auto known = calibration();
  if (!known) return Status::ok();
  return statusOf(capabilities_.find<Calibrator>()->calibrationConfig().faultOf(*known));
}

Component::Figures Estimator::figures() const {
  auto figures = backend_->figures();
  for (const auto source :
       {ConsistencyMonitor::kRange, ConsistencyMonitor::kBearing, ConsistencyMonitor::kMotion})
    figures.emplace_back(std::string(ConsistencyMonitor::name(source)) + "_noise_factor",
                         noise_.scale(source));
  const auto known = calibration();
  if (!known) return figures;
  const auto& config = capabilities_.find<Calibrator>()->calibrationConfig();
  for (const auto& parameter : config.parametersOf(*known)) {
    figures.emplace_back(parameter.name, parameter.value);
    figures.emplace_back(parameter.name + "_sigma", parameter.sigma);
  }
  return figures;
}

void Estimator::reportStep(const Intake::Step& step) {
  StepReport report;
  report.stamp = step.stamp;
  if (step.trigger) report.trigger = step.trigger->port->name;
  doubt_.judgeLoss(isLost(), backend_->pose().pose, step.stamp);
  report.pose = reportedPose();
  // at the very start of motion none has been applied yet
  if (const auto motion = last_motion_ ? last_motion_ : intake_.arrivals().pending) {
    report.odometry_pose = last_motion_ ? motion->odometry_end : motion->odometry_start;
    report.odometry_frame = motion->odometry_frame;
    report.base_frame = motion->base_frame;
  }
  frames_.complete(report.odometry_frame, report.base_frame);
  report.has_motion = carrier_ != nullptr;
  report.statistics = statistics();
  if (const auto* viewer = capabilities_.find<ViewReporter>())
    report.view = viewer->viewStatistics();
  report.doubt = doubt();
  report.trust = trust(report.doubt);
  report.restarted = step.restart;
  events_.complete(report, capabilities_);
  if (isWithoutCovariance(capabilities_)) report.pose.covariance.setZero();
  pose_ = FilterPose::of(report.stamp, report.pose.pose);
  report_ = std::move(report);
}

Counters Estimator::counters() const {
  Counters all = intake_.counters();
  all.add(counters_);
  all.add(backend_->counters());
  all.add(relocaliser_.counters());
  all.add(fragment_.counters());
  return all;
}

void Estimator::saveState(ArchiveWriter& archive) const {
  archive(*this);
  backend_->saveState(archive);
}

void Estimator::restoreState(ArchiveReader& archive) {
  archive(*this);
  backend_->restoreState(archive);
}

}  // namespace slam
