// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_report.hpp"

#include <fmt/format.h>

#include <utility>

namespace slam::gyro {
namespace {

constexpr Duration kPatience = std::chrono::seconds(1);

}  // namespace

GyroReport::GyroReport(std::string other, std::string instead)
    : other_(std::move(other)), instead_(std::move(instead)) {}

void GyroReport::reset() {
  said_ = GyroUse::kTurn;
  silent_for_ = {};
  counters_.clear();
}

Status GyroReport::add(const Motion& motion, GyroUse use, GyroTrust::Verdict verdict,
                       bool has_measured_turn) {
  if (has_measured_turn) said_ = GyroUse::kTurn;
  count(use);
  silent_for_ = use == GyroUse::kSilent ? silent_for_ + (motion.end - motion.start) : Duration{};
  const auto sentence = sentenceOf(use, verdict);
  if (sentence.empty() || said_ == use) return Status::ok();
  said_ = use;
  return Status::warning(sentence + "; " + instead_);
}

void GyroReport::count(GyroUse use) {
  if (use == GyroUse::kSilent) counters_.add("gyro_silent");
  if (use == GyroUse::kStuck) counters_.add("gyro_stuck");
  if (use == GyroUse::kImplausible || use == GyroUse::kBurst) counters_.add("gyro_implausible");
}

std::string GyroReport::sentenceOf(GyroUse use, GyroTrust::Verdict verdict) const {
  using Verdict = GyroTrust::Verdict;
  if (use == GyroUse::kSilent && silent_for_ >= kPatience)
    return "the IMU is silent; see whether its driver runs and whether its stamps are right";
  if (use == GyroUse::kStuck)
    return fmt::format(
        "the IMU repeats one angular velocity while {} measured turns; start its driver again",
        other_);
  if (use == GyroUse::kBurst)
    return fmt::format(
        "the IMU measures a turn that is faster than robots spin, contrary to {}; see whether its "
        "cable is loose",
        other_);
  if (use != GyroUse::kImplausible) return "";
  if (verdict == Verdict::kTooLarge)
    return fmt::format(
        "the IMU measures turns several times as large as those that {} measured, as one that "
        "counts in degrees; set imu.units in the robot file",
        other_);
  if (verdict == Verdict::kOpposite)
    return fmt::format(
        "the IMU measures turns opposite to those that {} measured, as one that is mounted upside "
        "down; correct its transform to the robot's base frame or imu.sensor_pose in the robot "
        "file",
        other_);
  if (verdict == Verdict::kUnrelated)
    return fmt::format(
        "the IMU does not measure the turns that {} measured, as one whose mount is another; "
        "correct its transform to the robot's base frame or imu.sensor_pose in the robot file",
        other_);
  return "";
}

}  // namespace slam::gyro
