// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/calibrated_gyro.hpp"

#include <cmath>

namespace slam::gyro {
namespace {

constexpr double kTurnRate = 0.05;  // above which odometry turns, or contradicts [rad/s]

double secondsOf(const Motion& motion) { return seconds(motion.end - motion.start); }

bool turns(const Motion& motion) {
  return std::abs(motion.increment.theta()) > kTurnRate * secondsOf(motion);
}

}  // namespace

void CalibratedGyro::configure(const ImuConfig& config, const GyroReport& report) {
  config_ = config;
  report_ = report;
  reset();
}

void CalibratedGyro::reset() {
  track_.clear();
  calibration_ = GyroCalibration(config_);
  trust_.reset();
  report_.reset();
  counters_.clear();
}

GyroUse CalibratedGyro::judge(const std::optional<GyroTurn>& turn, const Motion& motion,
                              bool is_resting) const {
  if (!turn) return GyroUse::kSilent;
  const double angle = calibration_.angle(*turn);
  const bool contradicts = std::abs(angle - motion.increment.theta()) > kTurnRate * turn->seconds;
  if (turn->is_repeated && contradicts) return GyroUse::kStuck;
  if (is_resting && (!isProven() || calibration_.rests(*turn))) return GyroUse::kRest;
  if (isProven() && GyroTrust::isBurst(turn->fastest, motion)) return GyroUse::kBurst;
  const bool is_believed = trust_.believes(angle, motion, std::sqrt(calibration_.biasVariance()));
  return is_believed ? GyroUse::kTurn : GyroUse::kImplausible;
}

Status CalibratedGyro::pass(const std::optional<GyroTurn>& turn, const Motion& motion,
                            bool gives_heading) {
  calibration_.predict(secondsOf(motion), motion.increment.theta(), gives_heading);
  calibration_.pause();
  const auto use = turn ? GyroUse::kTurn : GyroUse::kSilent;
  return report_.add(motion, use, trust_.verdict(), false);
}

Status CalibratedGyro::learn(const std::optional<GyroTurn>& turn, const Motion& motion, GyroUse use,
                             bool is_resting, bool gives_heading) {
  const bool has_turned = use == GyroUse::kTurn;
  const double angle = has_turned ? calibration_.angle(*turn) : motion.increment.theta();
  calibration_.predict(secondsOf(motion), angle, gives_heading);
  if (!turn || use == GyroUse::kStuck || use == GyroUse::kBurst)
    calibration_.pause();
  else
    calibrate(*turn, motion, is_resting);
  track_.forgetBefore(motion.end);
  const bool has_measured = has_turned && !turn->is_repeated && turns(motion);
  return report_.add(motion, use, trust_.verdict(), has_measured);
}

void CalibratedGyro::calibrate(const GyroTurn& turn, const Motion& motion, bool is_resting) {
  trust_.add(calibration_.angle(turn), motion, std::sqrt(calibration_.biasVariance()));
  if (is_resting)
    calibration_.learnAtRest(turn);
  else if (isProven())
    calibration_.learnBeside(turn, motion);
  else
    calibration_.pause();
}

Counters CalibratedGyro::counters() const {
  auto all = counters_;
  all.add(report_.counters());
  return all;
}

}  // namespace slam::gyro
