// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_trust.hpp"

#include <algorithm>
#include <cmath>

namespace slam::gyro {
namespace {

constexpr double kVoteTime = 0.5, kMostTime = 2.0;  // [s]
constexpr double kVoteRate = 0.1;                   // of the wheels, that says nothing [rad/s]
/// Wheels of unequal size may measure this turn on each metre of a straight way [rad/m].
constexpr double kStraightTurn = 0.15;
/// Robot files may say too little of the wheels' noise.
constexpr double kNoiseSigmas = 5.0;
/// Noise takes at most this share of a turn: robot files count a wrong wheelbase as noise.
constexpr double kMostNoise = 0.5;
constexpr double kMostTurn = 0.5;  // that one vote counts for [rad]
/// Wheels that slip, or whose base is not known, leave the ratio of gyro to wheels within these.
constexpr double kLeastRatio = 0.2, kMostRatio = 5.0;
/// So large turns prove the gyro, refute one that is not proven, and refute, by kind, one that is
/// [rad]. Wheels that spin on the spot report turns that do not happen: those prove little.
constexpr double kProves = 0.5, kRefutesUnproven = 1.0;
constexpr std::array<double, 3> kRefutesProven = {1.0, 1.0, 10.0};

/// A robot spins no faster than this unless its wheels turn it [rad/s].
constexpr double kFastestSpin = 10.0;

enum Kind : std::size_t { kTooLargeKind, kOppositeKind, kUnrelatedKind };
constexpr std::array<GyroTrust::Verdict, 3> kVerdicts = {
    GyroTrust::Verdict::kTooLarge, GyroTrust::Verdict::kOpposite, GyroTrust::Verdict::kUnrelated};

bool isRatioOfWheels(double gyro, double wheels) {
  return gyro * wheels > 0.0 && std::abs(gyro) >= kLeastRatio * std::abs(wheels) &&
         std::abs(gyro) <= kMostRatio * std::abs(wheels);
}

}  // namespace

void GyroTrust::Turns::add(double turned, const Motion& motion) {
  seconds += slam::seconds(motion.end - motion.start);
  gyro += turned;
  wheels += motion.increment.theta();
  variance += motion.covariance(2, 2);
  way += motion.increment.position().norm();
}

double GyroTrust::Turns::straight() const { return kVoteRate * seconds + kStraightTurn * way; }

double GyroTrust::Turns::noise() const { return kNoiseSigmas * std::sqrt(variance); }

bool GyroTrust::Turns::isTurn() const {
  const double turned = std::abs(wheels);
  return turned >= straight() + std::min(kMostNoise * turned, noise());
}

bool GyroTrust::Turns::contradict(double bias_sigma) const {
  const double slack = straight() + noise() + kNoiseSigmas * bias_sigma * seconds;
  return std::abs(gyro - wheels) > slack && !isRatioOfWheels(gyro, wheels);
}

bool GyroTrust::isSpin(double rate) { return std::abs(rate) > kFastestSpin; }

bool GyroTrust::isBurst(double rate, const Motion& wheels) {
  const double turn = rate * slam::seconds(wheels.end - wheels.start);
  return isSpin(rate) && !isRatioOfWheels(turn, wheels.increment.theta());
}

void GyroTrust::add(double gyro, const Motion& wheels, double bias_sigma) {
  block_.add(gyro, wheels);
  const bool contradicts = block_.contradict(bias_sigma), is_full = block_.seconds >= kVoteTime;
  if (contradicts || is_full) is_doubted_ = contradicts;
  if (is_full) block_ = {};
  since_vote_.add(gyro, wheels);
  if (since_vote_.seconds < (since_vote_.isTurn() ? kVoteTime : kMostTime)) return;
  if (since_vote_.isTurn()) vote();
  since_vote_ = {};
}

void GyroTrust::vote() {
  const double gyro = since_vote_.gyro, wheels = since_vote_.wheels;
  const double weight = std::min(kMostTurn, std::abs(wheels));
  if (isRatioOfWheels(gyro, wheels)) return voteFor(weight);
  if (std::abs(gyro) > kMostRatio * std::abs(wheels)) return voteAgainst(kTooLargeKind, weight);
  voteAgainst(gyro / wheels < -kLeastRatio ? kOppositeKind : kUnrelatedKind, weight);
}

void GyroTrust::voteFor(double weight) {
  fits_ = std::min(kProves, fits_ + weight);
  for (auto& turns : against_) turns = std::max(0.0, turns - weight);
  if (fits_ < kProves) return;
  against_.fill(0.0);
  verdict_ = Verdict::kProven;
}

void GyroTrust::voteAgainst(std::size_t kind, double weight) {
  fits_ = std::max(0.0, fits_ - weight);
  against_[kind] += weight;
  const double most = verdict_ == Verdict::kProven ? kRefutesProven[kind] : kRefutesUnproven;
  if (against_[kind] < most) return;
  against_[kind] = most;
  fits_ = 0.0;
  verdict_ = kVerdicts[kind];
}

bool GyroTrust::believes(double gyro, const Motion& wheels, double bias_sigma) const {
  if (verdict_ == Verdict::kProven) return true;
  if (verdict_ != Verdict::kUnproven) return false;
  auto turns = block_;
  turns.add(gyro, wheels);
  return !is_doubted_ && !turns.contradict(bias_sigma);
}

}  // namespace slam::gyro
