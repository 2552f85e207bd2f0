// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_track.hpp"

#include <algorithm>
#include <utility>

namespace slam::gyro {
namespace {

/// Between two samples that are farther apart the rate is not known.
constexpr Duration kLongestHole = std::chrono::milliseconds(150);
/// Samples are kept for so long for those who ask late.
constexpr Duration kGyroKept = std::chrono::seconds(30);
/// A noisy gyro does not measure the same value so often in a row.
constexpr std::size_t kRepeatsOfStuck = 10;

/// The share of the way from a to b at which the stamp lies.
double shareAt(Stamp a, Stamp b, Stamp at) { return seconds(at - a) / seconds(b - a); }

}  // namespace

GyroTrack::Reading GyroTrack::readingOf(const ImuSample& sample) {
  Reading reading;
  reading.stamp = reading.same_since = sample.stamp;
  reading.rate = sample.angular_velocity.z();
  reading.variance = sample.covariance(2, 2);
  return reading;
}

void GyroTrack::add(const ImuSample& sample, Counters& counters) {
  const auto reading = readingOf(sample);
  if (const auto odd = std::exchange(odd_, std::nullopt)) {
    if (isNext(odd->stamp, reading.stamp)) {
      readings_.clear();
      append(*odd);
      append(reading);
      return;
    }
    counters.add("gyro_stamp_jump");
  }
  if (readings_.empty() || isNext(readings_.back().stamp, reading.stamp)) return append(reading);
  const auto& last = readings_.back();
  const bool is_near = reading.stamp > last.stamp - kStampJump && reading.stamp <= last.stamp;
  if (is_near)
    counters.add("gyro_late");
  else
    odd_ = reading;
}

void GyroTrack::append(Reading reading) {
  if (!readings_.empty() && readings_.back().rate == reading.rate) {
    reading.same_since = readings_.back().same_since;
    reading.repeats = readings_.back().repeats + 1;
  }
  readings_.push_back(reading);
  forgetBefore(reading.stamp - kGyroKept);
}

void GyroTrack::forgetBefore(Stamp stamp) {
  while (readings_.size() > 1 && readings_[1].stamp <= stamp) readings_.pop_front();
}

std::optional<Stamp> GyroTrack::end() const {
  if (readings_.empty()) return std::nullopt;
  return readings_.back().stamp;
}

std::optional<GyroTurn> GyroTrack::between(Stamp start, Stamp end) const {
  const auto after = [](Stamp stamp, const Reading& reading) { return stamp < reading.stamp; };
  auto next = std::upper_bound(readings_.begin(), readings_.end(), start, after);
  if (next == readings_.begin()) return std::nullopt;
  GyroTurn turn;
  for (Stamp reached = start; reached < end; ++next) {
    if (next == readings_.end()) return std::nullopt;
    const auto& a = *std::prev(next);
    const auto& b = *next;
    if (b.stamp - a.stamp > kLongestHole) return std::nullopt;
    const Stamp until = std::min(b.stamp, end);
    const double middle =
        0.5 * (shareAt(a.stamp, b.stamp, reached) + shareAt(a.stamp, b.stamp, until));
    const double dt = seconds(until - reached);
    turn.pieces.push_back({dt, dt * (a.rate + middle * (b.rate - a.rate))});
    turn.seconds += dt;
    turn.angle += turn.pieces.back().angle;
    turn.given_variance += dt * seconds(b.stamp - a.stamp) * b.variance;
    for (const double rate : {a.rate, b.rate})
      if (std::abs(rate) > std::abs(turn.fastest)) turn.fastest = rate;
    turn.is_repeated = a.repeats >= kRepeatsOfStuck && a.same_since <= start;
    reached = until;
  }
  return turn;
}

}  // namespace slam::gyro
