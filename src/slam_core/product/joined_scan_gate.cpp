// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/joined_scan_gate.hpp"

#include <fmt/format.h>

#include <utility>

#include "slam_core/common/starvation.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {
namespace {

const GateRegistrar<JoinedScanGate> kJoinedScan(JoinedScanGate::kName);

constexpr std::size_t kMostHeld = 200;  ///< scans of each laser

Status silentLaser(const std::string& laser, const std::string& other, Stamp since) {
  return Status::warning(
      fmt::format("the {} laser has sent no scan since {:.1f}: the map is made of the scans of the "
                  "{} laser alone; is it unplugged, or has its driver ended?",
                  laser, seconds(since - Stamp()), other));
}

/// Two lasers cannot be at one place; scanners one above the other have frames of their own.
bool haveOneMount(const LaserScan& front, const LaserScan& rear) {
  return front.sensor_frame == rear.sensor_frame &&
         front.sensor_pose.vector() == rear.sensor_pose.vector();
}

}  // namespace

void JoinedScanGate::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", [this](const LaserScan& scan) { setFront(scan); });
  ports.takes<LaserScan>("rear_scan", "scans of the rear laser",
                         [this](const LaserScan& scan) { setRear(scan); });
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.makes<LaserScan>(kName, scan_);
}

void JoinedScanGate::configure(Settings& settings) {
  configure(durationFromSeconds(settings.read<ProductConfig>().source_timeout));
}

void JoinedScanGate::configure(Duration source_timeout) {
  patience_ = durationFromSeconds(kPatience * seconds(source_timeout));
  reset();
}

void JoinedScanGate::reset() {
  Scans::Limits limits;
  limits.source_timeout = patience_;
  limits.triggers = kMostHeld;
  collator_ = Scans(2, limits);
  restart();
  sequence_ = 0;
  scan_.reset();
  counters_.clear();
}

void JoinedScanGate::restart() {
  front_.reset();
  rear_.reset();
  start_.reset();
  last_front_.reset();
  last_rear_.reset();
  front_interval_ = rear_interval_ = Duration::zero();
  out_.clear();
}

void JoinedScanGate::push(Source source, const LaserScan& scan) {
  collator_.push(source, scan.stamp, scan.sequence, {source == kRear, scan});
}

/// The back-end gets the same motion and says what is wrong with it.
void JoinedScanGate::set(const Motion& motion) {
  if (faultOf(motion).empty()) return collator_.push(motion);
  counters_.add("invalid_motion");
  collator_.skip(motion.sequence);
}

Status JoinedScanGate::execute() {
  scan_.reset();
  auto status = Status::ok();
  while (out_.empty()) {
    const auto step = collator_.next();
    if (!step) return moreUrgent(status, starvation());
    status = moreUrgent(status, take(*step));
  }
  scan_ = std::move(out_.front());
  out_.pop_front();
  return status;
}

Status JoinedScanGate::starvation() const {
  const auto front = slam::starvation(collator_, kFront, "laser scans");
  return front.isOk() ? slam::starvation(collator_, kRear, "laser scans") : front;
}

Status JoinedScanGate::take(const Scans::Step& step) {
  if (step.restart) restart();
  if (!start_) start_ = step.stamp;
  for (const auto& motion : step.motions)
    for (auto* waiting : {&front_, &rear_})
      if (*waiting && motion.start == (*waiting)->now) {  // what a hole follows leads nowhere
        (*waiting)->T_then_now = (*waiting)->T_then_now * motion.increment;
        (*waiting)->now = motion.end;
      }
  if (!step.trigger) return Status::ok();
  return step.trigger->is_rear ? takeRear(step.trigger->scan) : takeFront(step.trigger->scan);
}

Status JoinedScanGate::takeFront(const LaserScan& scan) {
  letOutFront();
  front_interval_ = last_front_ ? scan.stamp - *last_front_ : Duration::zero();
  last_front_ = scan.stamp;
  const auto mounts = rear_ && haveOneMount(scan, rear_->scan) ? leaveOutRear(scan) : Status::ok();
  const auto since = last_rear_.value_or(*start_);
  const auto apart = scan.stamp - since;
  const bool is_silent = apart > patience_;
  auto before = fanBefore(scan.stamp);
  const bool is_nearest = before && 2 * apart <= rear_interval_;
  if (is_nearest || is_silent)
    letOutFront(scan, before);
  else
    front_ = Waiting{scan, Pose2(), scan.stamp, std::move(before), apart};
  return is_silent ? silentLaser("rear", "front", since) : mounts;
}

Status JoinedScanGate::takeRear(const LaserScan& scan) {
  rear_interval_ = last_rear_ ? scan.stamp - *last_rear_ : Duration::zero();
  last_rear_ = scan.stamp;
  const auto since = last_front_.value_or(*start_);
  if (scan.stamp - since > patience_) {
    letOutFront();
    counters_.add("rear_alone");
    letOut(scan);
    return silentLaser("front", "rear", since);
  }
  if (front_ && haveOneMount(front_->scan, scan)) return leaveOutRear(scan);
  if (front_ && isNearest(scan)) {
    if (front_->before) counters_.add("rear_left_out");
    LaserFan fan = scan;
    fan.sensor_pose = front_->T_then_now * fan.sensor_pose;
    letOutFront(std::exchange(front_, std::nullopt)->scan, fan);
    return Status::ok();
  }
  letOutFront();
  if (rear_) counters_.add("rear_left_out");
  rear_ = Waiting{scan, Pose2(), scan.stamp, std::nullopt, {}};
  return Status::ok();
}

Status JoinedScanGate::leaveOutRear(const LaserScan& scan) {
  rear_.reset();
  counters_.add("same_mount");
  return Status::warning(fmt::format(
      "both lasers have the frame '{}', and with it one mount: the scans of the rear laser are "
      "left out; give each driver a frame_id of its own, and publish where each laser is mounted",
      scan.sensor_frame));
}

bool JoinedScanGate::isNearest(const LaserScan& rear) const {
  const auto apart = rear.stamp - front_->scan.stamp;
  const bool is_next_nearer = front_interval_ > Duration::zero() && 2 * apart > front_interval_;
  return front_->now == rear.stamp && !is_next_nearer && (!front_->before || apart < front_->apart);
}

std::optional<LaserFan> JoinedScanGate::fanBefore(Stamp now) {
  const auto rear = std::exchange(rear_, std::nullopt);
  if (!rear) return std::nullopt;
  if (rear->now != now || now - rear->scan.stamp > patience_) {
    counters_.add("rear_left_out");
    return std::nullopt;
  }
  LaserFan fan = rear->scan;
  fan.sensor_pose = rear->T_then_now.between(fan.sensor_pose);
  return fan;
}

void JoinedScanGate::letOutFront() {
  if (!front_) return;
  const auto front = std::exchange(front_, std::nullopt);
  letOutFront(front->scan, front->before);
}

void JoinedScanGate::letOutFront(LaserScan scan, const std::optional<LaserFan>& rear) {
  if (!rear) counters_.add("front_alone");
  if (rear && !rear->beams.empty()) scan.further.push_back(*rear);
  letOut(std::move(scan));
}

void JoinedScanGate::letOut(LaserScan scan) {
  scan.sequence = sequence_++;
  out_.push_back(std::move(scan));
}

Counters JoinedScanGate::counters() const {
  Counters all = collator_.counters();
  all.add(counters_);
  return all;
}

Counters JoinedScanGate::held() const {
  Counters held;
  held.add("waiting_front", collator_.triggers(kFront).items().size());
  held.add("waiting_rear", collator_.triggers(kRear).items().size());
  return held;
}

std::uint64_t JoinedScanGate::dropped() const {
  const auto& collated = collator_.counters();
  return collated["late"] + collated["lost"] + collated["overflow"] + collated["stamp_jump"] +
         collator_.setAside();
}

void JoinedScanGate::saveState(ArchiveWriter& archive) const { archive(*this); }

void JoinedScanGate::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam
