// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/intake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/nearest_name.hpp"

namespace slam {
namespace {

constexpr const char* kCoasted =
    "motion is missing and the odometry's poses do not tell it: the robot is taken to have gone on "
    "at its last velocity";

/// Adds what another detector has seen in the same image: as one array it is one step, of which the
/// robot's pose is corrected by all that was seen, and a particle is drawn where all of it fits.
/// @return false where it is of another sensor or another kind
bool joins(const Intake::Trigger& other, const Intake::Trigger& trigger) {
  const auto kind = kindOf<LandmarkObservationArray>();
  if (trigger.port->kind != kind || other.port->kind != kind) return false;
  auto& all = *static_cast<LandmarkObservationArray*>(trigger.value.get());
  const auto& more = *static_cast<const LandmarkObservationArray*>(other.value.get());
  if (more.sensor_frame != all.sensor_frame ||
      more.sensor_pose.vector() != all.sensor_pose.vector())
    return false;
  auto& seen = all.observations;
  seen.insert(seen.end(), more.observations.begin(), more.observations.end());
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  return true;
}

/// What is wrong with how a back-end declares an input; empty where nothing is.
std::string faultOf(const InputPort& port) {
  if (port.time == TimeRole::kCarrier && port.kind != kindOf<Motion>())
    return "the back-end's input '" + port.name + "' carries time on, but takes " +
           nameOf(port.kind) + "; only slam::Motion can do that";
  if (port.time == TimeRole::kTrigger && port.traits.hold == nullptr)
    return "the back-end's input '" + port.name + "' triggers steps, but " + nameOf(port.kind) +
           " has no stamp; give it one, or declare the input as latched";
  return "";
}

}  // namespace

void Intake::configure(Settings& settings, const Ports& ports, bool takes_lines) {
  FaultCollector faults;
  faults.attempt([&] { screen_.configure(settings, takes_lines); });
  faults.attempt([&] { frames_ = settings.read<FramesConfig>(); });
  faults.attempt([&] {
    source_timeout_ = durationFromSeconds(settings.read<ProductConfig>().source_timeout);
  });
  ports_ = &ports;
  triggers_.clear();
  has_carrier_ = false;
  for (const auto& port : ports.inputs()) {
    if (const auto fault = faultOf(port); !fault.empty()) faults.add(fault);
    if (port.time == TimeRole::kTrigger) triggers_.push_back(&port);
    has_carrier_ = has_carrier_ || port.time == TimeRole::kCarrier;
  }
  not_expected_.clear();
  faults.raise();
  reset();
}

void Intake::reset() {
  Collator<Motion, Trigger>::Limits limits;
  limits.source_timeout = source_timeout_;
  limits.has_motion = has_carrier_;
  collator_ = Collator<Motion, Trigger>(triggers_.size(), limits);
  for (std::size_t source = 0; source < triggers_.size(); ++source)
    if (std::count(not_expected_.begin(), not_expected_.end(), triggers_[source]->name) > 0)
      collator_.expectNothing(source);
  screen_.reset();
  gap_.reset();
  moved_frame_.clear();
  fault_.clear();
  counters_.clear();
  continuity_.reset();
}

/// Without motion nothing tells where the robot has gone.
void resume(Intake& intake, Interruption interruption) {
  intake.gap_.resume(interruption);
  intake.may_go_on_ = interruption == Interruption::kOfThisProcess;
  intake.continuity_ = intake.has_carrier_ ? std::nullopt : std::optional(false);
}

void Intake::expectNothing(const std::string& input) {
  not_expected_.push_back(input);
  for (std::size_t source = 0; source < triggers_.size(); ++source)
    if (triggers_[source]->name == input) collator_.expectNothing(source);
}

void Intake::take(const std::string& input, Kind kind, const void* value) {
  if (const auto* port = ports_->input(input, kind)) take(*port, value);
}

void Intake::take(Kind kind, const void* value) {
  const auto& inputs = ports_->inputs();
  const auto port = std::find_if(inputs.begin(), inputs.end(),
                                 [kind](const auto& input) { return input.kind == kind; });
  if (port != inputs.end()) take(*port, value);
}

void Intake::take(const InputPort& port, const void* value) {
  if (port.time == TimeRole::kCarrier) return takeMotion(*static_cast<const Motion*>(value));
  if (port.time == TimeRole::kLatched)
    takeLatched(port, value);
  else
    takeTrigger(port, value);
}

void Intake::takeLatched(const InputPort& port, const void* value) {
  if (screen_.isFit(port, value)) port.set(value);
  if (const auto fault = screen_.takeFault(); !fault.empty()) fault_ = fault;
}

void Intake::takeMotion(Motion motion) {
  frames_.complete(motion.odometry_frame, motion.base_frame);
  warnOfBaseFrame(motion.base_frame);
  const auto fault = faultOf(motion);
  if (fault.empty()) {
    const auto bridge = gap_.bridge(motion);
    if (gap_.wentOn()) continuity_ = may_go_on_ && *gap_.wentOn();
    if (bridge == MotionGap::Bridge::kUnknown) return collator_.skip(motion.sequence);
    if (bridge == MotionGap::Bridge::kByPoses) counters_.add("bridged");
    if (bridge == MotionGap::Bridge::kByVelocity) {
      counters_.add("coasted");
      fault_ = kCoasted;
    }
    if (const auto& unknown = gap_.unknownWay())
      skipBetween(collator_, unknown->first, unknown->second);
    collator_.push(std::move(motion));
    return;
  }
  counters_.add("invalid_motion");
  collator_.skip(motion.sequence);
  fault_ = fault + "; it is left out";
}

void Intake::warnOfBaseFrame(const std::string& moved) {
  if (moved == std::exchange(moved_frame_, moved) || moved == frames_.base) return;
  fault_ = "odometry moves '" + moved + "', while the sensors' poses are looked up in '" +
           frames_.base + "': set frames.base to '" + moved + "' in the robot file";
}

void Intake::takeTrigger(const InputPort& port, const void* value) {
  const auto source = std::find(triggers_.begin(), triggers_.end(), &port) - triggers_.begin();
  const auto held = screen_.pass(port, value);
  if (const auto fault = screen_.takeFault(); !fault.empty()) fault_ = fault;
  if (held)
    collator_.push(static_cast<std::size_t>(source), held->stamp, held->sequence,
                   {&port, held->value});
  else
    collator_.skip(static_cast<std::size_t>(source), port.traits.hold(value).sequence);
}

std::optional<Intake::Step> Intake::next() {
  auto step = collator_.next();
  if (!step || !step->trigger) return step;
  for (const auto* other = dueAtTheSameTime(collator_);
       other != nullptr && joins(*other, *step->trigger); other = dueAtTheSameTime(collator_))
    collator_.next();
  return step;
}

void Intake::admit(const Trigger& trigger) {
  screen_.admit(*trigger.port, trigger.value.get());
  // what came with the array's arrival is said first
  if (const auto fault = screen_.takeFault(); fault_.empty()) fault_ = fault;
}

std::optional<Stamp> Intake::Arrivals::lastOf(const std::string& input) const {
  for (const auto& source : triggers)
    if (source.input == input) return source.last;
  return std::nullopt;
}

Counters Intake::Arrivals::held() const {
  Counters held;
  for (const auto& source : triggers) held.add(source.sentence, source.held);
  return held;
}

Intake::Arrivals Intake::arrivals() const {
  Arrivals arrivals{collator_.lastMotion(), std::nullopt, {}, starving()};
  if (const auto* motion = collator_.pending()) arrivals.pending = *motion;
  for (std::size_t source = 0; source < triggers_.size(); ++source) {
    const auto& queue = collator_.triggers(source);
    arrivals.triggers.push_back({triggers_[source]->name, triggers_[source]->sentence,
                                 queue.stamps().last(), queue.items().size()});
  }
  return arrivals;
}

std::string Intake::starving() const {
  std::vector<std::string> names;
  std::optional<Stamp> since;
  for (std::size_t source = 0; source < triggers_.size(); ++source) {
    const auto stamp = collator_.starvedSince(source, kPatience);
    if (!stamp) continue;
    names.push_back(triggers_[source]->sentence);
    since = since ? std::min(*since, *stamp) : *stamp;
  }
  if (!since) return "";
  return fmt::format("{} since {:.1f} wait for motion", join(names, " and "),
                     seconds(*since - Stamp()));
}

Counters Intake::counters() const {
  Counters all = counters_;
  all.add(screen_.counters());
  all.add(collator_.counters());
  all.add("set_aside", collator_.setAside());
  return all;
}

std::uint64_t Intake::dropped() const {
  const auto& collated = collator_.counters();
  return collated["late"] + collated["lost"] + collated["overflow"] + collated["stamp_jump"] +
         collated["abandoned"] + collated["in_gap"] + collator_.setAside() +
         counters_["invalid_motion"];
}

}  // namespace slam
