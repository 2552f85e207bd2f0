// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu/imu_gate.hpp"

#include <algorithm>

#include "slam_core/contract/known_sections.hpp"

namespace slam {
namespace {

/// Readings that wait longer than this are worth a word: the first ones come before the transform.
constexpr Duration kImuPatience = std::chrono::seconds(1);

const GateRegistrar<ImuGate> kImuGateRegistrar(ImuConfig::kSection);
const SectionRegistrar<ImuConfig> kImuSectionRegistrar;

constexpr const char* kNoGyro =
    "the IMU says that it has no gyro: all its rates are zero, and their covariance begins with "
    "-1; name the topic of an IMU that has one in topics.imu of the robot file, or correct what "
    "its driver sends";

std::string unknownMount(const std::string& frame) {
  return "it is not known how the IMU of frame '" + frame +
         "' is mounted; publish its static transform to the robot's base frame or give "
         "imu.sensor_pose in the robot file";
}

}  // namespace

void ImuGate::configure(const ImuConfig& config) {
  validate(config);
  config_ = config;
  mount_.reset();
  mount_fault_.clear();
  const auto configured = config.mount();
  is_mount_configured_ = false;
  if (configured) set(ImuMount{"", *configured});
  is_mount_configured_ = configured.has_value();
  reset();
}

void ImuGate::describe(Ports& ports) {
  ports.takes<ImuReading>("imu", "an IMU's angular velocities", this);
  ports.takes<ImuMount>("imu", "the IMU's mount", this).latched();
  ports.makes<ImuSample>("imu", sample_);
}

std::uint64_t ImuGate::dropped() const {
  return counters_["bad_reading"] + counters_["bad_mount"] + counters_["no_mount"] +
         counters_["no_gyro"];
}

Counters ImuGate::held() const {
  Counters held;
  held.add("no_mount", held_.size());
  return held;
}

void ImuGate::reset() {
  held_.clear();
  sample_.reset();
  counters_.clear();
}

void ImuGate::set(const ImuMount& mount) {
  if (is_mount_configured_) return;
  mount_ = mount;
  mount_fault_ = faultOf(mount);
}

Status ImuGate::execute() {
  sample_.reset();
  Status status;
  while (!sample_ && !held_.empty()) {
    if (frontMayWait()) return moreUrgent(status, waiting());
    status = moreUrgent(status, take(held_.front()));
    held_.pop_front();
  }
  return status;
}

/// Whether the oldest reading may wait for its mount: as long as it holds up none that could be
/// used.
bool ImuGate::frontMayWait() const {
  return held_.size() <= kCapacity &&
         std::none_of(held_.begin(), held_.end(), [&](const auto& r) { return hasMount(r); });
}

/// A mount of another frame is another IMU's.
bool ImuGate::hasMount(const ImuReading& reading) const {
  return mount_ && (is_mount_configured_ || mount_->imu_frame == reading.frame);
}

Status ImuGate::waiting() const {
  const bool worth_a_word = held_.back().stamp - held_.front().stamp > kImuPatience;
  return worth_a_word ? Status::warning(unknownMount(held_.front().frame)) : Status::ok();
}

Status ImuGate::take(const ImuReading& driven) {
  if (!hasMount(driven)) return reject("no_mount", unknownMount(driven.frame));
  if (!mount_fault_.empty())
    return reject("bad_mount", "the IMU's mount cannot be used: " + mount_fault_ +
                                   "; correct its transform to the robot's base frame or "
                                   "imu.sensor_pose in the robot file");
  const bool is_in_degrees = config_.units == ImuConfig::Units::kDegrees;
  const auto reading = is_in_degrees ? fromDegrees(driven) : driven;
  if (const auto fault = faultOf(reading); !fault.empty())
    return reject("bad_reading", "a reading of the IMU cannot be used: " + fault +
                                     "; correct what the IMU's driver sends");
  if (saysNoGyro(reading)) return reject("no_gyro", kNoGyro);
  sample_ = toSample(reading, *mount_);
  return Status::ok();
}

Status ImuGate::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

}  // namespace slam
