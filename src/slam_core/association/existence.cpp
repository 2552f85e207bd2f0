// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/existence.hpp"

#include <algorithm>
#include <cmath>

namespace slam::association {
namespace {

constexpr double kStretch = 0.3;       ///< way [m] or turn [rad] after which evidence counts again
constexpr double kBegun = 2.0;         ///< log odds of a landmark that has just been begun
constexpr double kMostOdds = 10.0;     ///< log odds that are not exceeded
constexpr double kEstablished = 6.0;   ///< log odds of a landmark to learn from
constexpr double kGhost = -4.0;        ///< log odds at which a landmark is removed
constexpr double kFalseShare = 0.1;    ///< of the detection probability: something else is there
constexpr double kRemembered = 500.0;  ///< hits and misses that are remembered

}  // namespace

Existence::Existence(const LandmarkMap& map) {
  for (const auto& landmark : map) log_odds_[landmark.id] = kMostOdds;
}

void Existence::move(const Motion& motion) {
  way_ += motion.increment.position().norm();
  turn_ += std::abs(motion.increment.theta());
}

bool Existence::isDue() const { return way_ >= kStretch || turn_ >= kStretch; }

/// Misses in a row are correlated: each counts less than one that is independent.
double Existence::detection() const { return std::clamp(hits_ / (hits_ + misses_), 0.05, 0.7); }

std::vector<LandmarkId> Existence::see(const Pose2& sensor,
                                       const std::vector<LandmarkPlace>& landmarks,
                                       const std::vector<LandmarkId>& seen,
                                       const SensorReach& reach) {
  seen_.insert(seen.begin(), seen.end());
  if (!isDue() || seen.empty()) return {};
  const double detected = detection(), is_false = kFalseShare * detected;
  const double hit = std::log(detected / is_false);
  const double miss = std::log((1.0 - detected) / (1.0 - is_false));
  std::vector<LandmarkId> ghosts;
  const auto T_sensor_map = sensor.inverse();
  for (const auto& [id, position] : landmarks) {
    auto& odds = log_odds_.try_emplace(id, kBegun).first->second;
    const bool is_seen = seen_.count(id) > 0;
    if (!is_seen && !reach.covers(T_sensor_map.transform(position))) continue;
    if (odds >= kEstablished) (is_seen ? hits_ : misses_) += 1.0;
    odds = std::min(kMostOdds, odds + (is_seen ? hit : miss));
    if (odds < kGhost) ghosts.push_back(id);
  }
  for (const auto id : ghosts) log_odds_.erase(id);
  const double excess = std::max(1.0, (hits_ + misses_) / kRemembered);
  hits_ /= excess;
  misses_ /= excess;
  seen_.clear();
  way_ = turn_ = 0.0;
  return ghosts;
}

}  // namespace slam::association
