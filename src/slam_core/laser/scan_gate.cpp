// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser/scan_gate.hpp"

#include <fmt/format.h>

#include "slam_core/contract/known_sections.hpp"

namespace slam {
namespace {

/// A laser that has been blind longer than this is worth a word.
constexpr Duration kPatience = std::chrono::seconds(1);

const GateRegistrar<ScanGate> kRegistrar(LaserConfig::kSection);
const GateRegistrar<RearScanGate> kRearRegistrar(RearLaserConfig::kSection);
const SectionRegistrar<LaserConfig> kSectionRegistrar;
const SectionRegistrar<RearLaserConfig> kRearSectionRegistrar;

}  // namespace

void ScanGate::configure(const LaserConfig& config) {
  validate(config);
  config_ = config;
  const auto pose = config.mount(section_);
  sweeps_.restart(pose ? std::optional(LaserMount{"", *pose}) : std::nullopt);
  reset();
}

void ScanGate::describe(Ports& ports) {
  ports.takes<LaserSweep>(port_, sentence_, [this](const LaserSweep& sweep) { set(sweep); });
  ports.takes<LaserMount>(port_, "the laser's mount", this).latched();
  ports.makes<LaserScan>(port_, scan_);
}

Counters ScanGate::held() const {
  Counters held;
  held.add("no_mount", sweeps_.size());
  return held;
}

void ScanGate::reset() {
  sweeps_.clear();
  scan_.reset();
  sequence_ = 0;
  blind_since_.reset();
  counters_.clear();
}

Status ScanGate::execute() {
  scan_.reset();
  auto next = sweeps_.pop();
  if (!next) {
    const auto frame = sweeps_.missingFrame();
    return frame ? Status::warning(unknownMount(*frame)) : Status::ok();
  }
  auto& sweep = *next;
  const auto usable = static_cast<float>(config_.range_max);
  if (usable > 0.0f && !(sweep.range_max < usable)) sweep.range_max = usable;
  const auto fault = faultOfSweep(sweep);
  if (fault) {
    counters_.add(fault->reason);
    scan_.emplace();
    scan_->stamp = sweep.stamp;
    scan_->sensor_frame = sweep.frame;
  } else {
    scan_ = toScan(sweep, sweeps_.mount());
    scan_->relative_sigma = config_.relative_sigma;
  }
  scan_->sequence = sequence_++;
  return fault ? Status::warning(fault->sentence) : watchBlindness();
}

Status ScanGate::watchBlindness() {
  if (!scan_->beams.empty()) {
    blind_since_.reset();
    return Status::ok();
  }
  counters_.add("no_range");
  if (!blind_since_ || scan_->stamp < *blind_since_) blind_since_ = scan_->stamp;
  if (scan_->stamp - *blind_since_ < kPatience) return Status::ok();
  return Status::warning(
      fmt::format("the laser of frame '{}' has told no range since {:.1f}: all are NaN, -Inf, 0 or "
                  "below range_min; is it covered, or does its driver fail?",
                  scan_->sensor_frame, seconds(*blind_since_ - Stamp())));
}

std::string ScanGate::unknownMount(const std::string& frame) const {
  return "it is not known where the laser of frame '" + frame +
         "' is mounted; publish its static transform to the robot's base frame or give " +
         section_ + ".sensor_pose in the robot file";
}

std::optional<ScanGate::Fault> ScanGate::faultOfSweep(const LaserSweep& sweep) const {
  if (!sweeps_.hasMount(sweep)) return Fault{"no_mount", unknownMount(sweep.frame)};
  if (const auto& fault = sweeps_.mountFault(); !fault.empty())
    return Fault{"bad_mount", "the laser's mount cannot be used: " + fault +
                                  "; correct its transform to the robot's base frame or " +
                                  section_ + ".sensor_pose in the robot file"};
  if (const auto fault = faultOf(sweep); !fault.empty())
    return Fault{"bad_scan",
                 "a scan cannot be used: " + fault + "; correct what the laser's driver sends"};
  return std::nullopt;
}

void ScanGate::saveState(ArchiveWriter& archive) const { archive(*this); }

void ScanGate::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam
