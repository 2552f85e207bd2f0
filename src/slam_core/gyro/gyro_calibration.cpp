// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/gyro/squared.hpp"

namespace slam::gyro {
namespace {

constexpr double kTurnMemory = 3.0;     // of the turns that a gyro's scale has made wrong [s]
constexpr double kRestDeviation = 4.0;  // [standard deviations]
/// A block at rest that is farther from the bias may be a robot that somebody turns. Who turns it
/// does not do so steadily for so long, and not before it has ever moved.
constexpr double kOtherDeviation = 5.0;                      // [standard deviations]
constexpr double kSteadyTime = 5.0, kFirstSteadyTime = 0.5;  // [s]
constexpr double kSteadyRate = 0.003;  // by which blocks may differ, at least [rad/s]
constexpr double kWindow = 1.0;        // [s]
/// A slip differs by this share of the wheels' turn rate from one second to the next.
constexpr double kSlip = 0.1;
/// The stamps of gyro and wheels may differ by so much for the same instant [s].
constexpr double kStampError = 0.1;

}  // namespace

GyroCalibration::GyroCalibration(const ImuConfig& config)
    : scale_sigma_(config.scale_sigma),
      bias_(config.bias_sigma, config.bias_random_walk),
      noise_(config.gyro_noise) {}

double GyroCalibration::variance(const GyroTurn& turn) const {
  const double noise = std::max(noise_.variance() * turn.seconds, turn.given_variance);
  const double turned = angle(turn);
  const double scale = squared(turned) + 2.0 * std::abs(turned) * recent_turns_[turned > 0.0];
  return noise + squared(scale_sigma_) * scale + bias_.headingVariance(turn.seconds);
}

bool GyroCalibration::rests(const GyroTurn& turn) const {
  const double sigma = std::sqrt(biasVariance() + noise_.variance() / turn.seconds);
  return std::abs(angle(turn)) <= kRestDeviation * sigma * turn.seconds;
}

void GyroCalibration::predict(double seconds, double turned, bool drifts) {
  bias_.predict(seconds, drifts);
  for (auto& turn : recent_turns_) turn *= std::exp(-seconds / kTurnMemory);
  if (drifts) recent_turns_[turned > 0.0] += std::abs(turned);
}

void GyroCalibration::learnAtRest(const GyroTurn& turn) {
  beside_ = {};
  if (const auto block = blocks_.add(turn.angle, turn.seconds, noise_)) observe(*block);
}

void GyroCalibration::observe(const RestRate& block) {
  const double variance = noise_.variance() / block.seconds;
  if (bias_.deviationOf(block.rate(), variance) > kOtherDeviation) return contradict(block);
  bias_.observeAtRest(block.rate(), variance);
  other_ = {};
}

void GyroCalibration::contradict(const RestRate& block) {
  const double rate = block.rate();
  if (other_.seconds == 0.0) other_.least = other_.most = rate;
  other_.least = std::min(other_.least, rate);
  other_.most = std::max(other_.most, rate);
  other_.seconds += block.seconds;
  other_.angle += block.angle;
  const double sigma = std::sqrt(noise_.variance() / block.seconds);
  if (other_.most - other_.least > std::max(kSteadyRate, 2.0 * kRestDeviation * sigma)) other_ = {};
  if (other_.seconds < (bias_.hasRested() ? kSteadyTime : kFirstSteadyTime)) return;
  const auto steady = std::exchange(other_, {});
  bias_.forget();
  bias_.observeAtRest(steady.angle / steady.seconds, noise_.variance() / steady.seconds);
}

void GyroCalibration::learnBeside(const GyroTurn& turn, const Motion& wheels) {
  blocks_.clear();
  other_ = {};
  auto& window = beside_;
  window.last_rate = angle(turn) / turn.seconds;
  if (window.seconds == 0.0) window.first_rate = window.last_rate;
  window.seconds += turn.seconds;
  window.gyro += turn.angle;
  window.wheels += wheels.increment.theta();
  window.way += wheels.increment.x();
  window.variance += wheels.covariance(2, 2);
  if (window.seconds < kWindow) return;
  const auto full = std::exchange(beside_, {});
  const double T = full.seconds, turn_rate = full.gyro / T - bias();
  const double variance = full.variance / squared(T) + noise_.variance() / T +
                          squared(kSlip * turn_rate) +
                          squared(kStampError * (full.last_rate - full.first_rate) / T);
  bias_.observeBesideWheels((full.gyro - full.wheels) / T, full.way / T, turn_rate, variance);
}

void GyroCalibration::pause() {
  blocks_.clear();
  beside_ = {};
  other_ = {};
}

Component::Figures figuresOf(const GyroCalibration& calibration) {
  return {{"gyro_bias", calibration.bias()},
          {"gyro_bias_sigma", std::sqrt(calibration.biasVariance())},
          {"gyro_noise", std::sqrt(calibration.noiseVariance())}};
}

}  // namespace slam::gyro
