// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu/imu_gate.hpp"

#include "slam_core/contract/known_sections.hpp"

namespace slam {
namespace {

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
  const auto pose = config.mount();
  readings_.restart(pose ? std::optional(ImuMount{"", *pose}) : std::nullopt);
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
  held.add("no_mount", readings_.size());
  return held;
}

void ImuGate::reset() {
  readings_.clear();
  sample_.reset();
  counters_.clear();
}

Status ImuGate::execute() {
  sample_.reset();
  Status status;
  while (!sample_) {
    const auto reading = readings_.pop();
    if (!reading) return moreUrgent(status, waiting());
    status = moreUrgent(status, take(*reading));
  }
  return status;
}

Status ImuGate::waiting() const {
  const auto frame = readings_.missingFrame();
  return frame ? Status::warning(unknownMount(*frame)) : Status::ok();
}

Status ImuGate::take(const ImuReading& driven) {
  if (!readings_.hasMount(driven)) return reject("no_mount", unknownMount(driven.frame));
  if (const auto& fault = readings_.mountFault(); !fault.empty())
    return reject("bad_mount", "the IMU's mount cannot be used: " + fault +
                                   "; correct its transform to the robot's base frame or "
                                   "imu.sensor_pose in the robot file");
  const bool is_in_degrees = config_.units == ImuConfig::Units::kDegrees;
  const auto reading = is_in_degrees ? fromDegrees(driven) : driven;
  if (const auto fault = faultOf(reading); !fault.empty())
    return reject("bad_reading", "a reading of the IMU cannot be used: " + fault +
                                     "; correct what the IMU's driver sends");
  if (saysNoGyro(reading)) return reject("no_gyro", kNoGyro);
  sample_ = toSample(reading, readings_.mount());
  return Status::ok();
}

Status ImuGate::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

void ImuGate::saveState(ArchiveWriter& archive) const { archive(*this); }

void ImuGate::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam
