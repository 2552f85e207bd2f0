// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/relapses.hpp"

#include <algorithm>

namespace slam {
namespace {

/// A place at which the robot has been for so long without being lost was right.
constexpr Duration kSoon = std::chrono::seconds(15);

/// Smaller jumps are no other place [m].
constexpr double kLeastJump = 0.5;

/// For how long the robot must stay found after so many relapses.
Duration probationAfter(int relapses) {
  constexpr int kMostDoublings = 6;
  return std::chrono::seconds(1) * (1 << std::min(relapses - 1, kMostDoublings));
}

/// Whether it is not the place that is wrong, but the map.
bool isHopeless(int relapses, double largest_jump) {
  return relapses >= Relapses::kHopeless && largest_jump < kLeastJump;
}

}  // namespace

void Relapses::judge(bool is_lost, const Eigen::Vector2d& robot, Stamp stamp) {
  if (is_lost && !is_lost_) lose(stamp);
  if (!is_lost && is_lost_) find(robot, stamp);
  if (on_probation_until_ && stamp >= *on_probation_until_) on_probation_until_.reset();
  is_lost_ = is_lost;
  robot_ = robot;
}

void Relapses::lose(Stamp stamp) {
  const bool is_soon =
      isHopeless(count_, largest_jump_) ||
      (found_ && (stamp - *found_ < kSoon || stamp - *found_ < 2 * probationAfter(count_ + 1)));
  count_ = is_soon ? count_ + 1 : 0;
  if (!is_soon) largest_jump_ = 0.0;
  on_probation_until_.reset();
}

void Relapses::find(const Eigen::Vector2d& robot, Stamp stamp) {
  largest_jump_ = std::max(largest_jump_, (robot - robot_).norm());
  found_ = stamp;
  if (isHopeless(count_, largest_jump_))
    on_probation_until_ = Stamp::max();
  else if (count_ > 0)
    on_probation_until_ = stamp + probationAfter(count_);
}

double Relapses::extent() const { return std::max(largest_jump_, kLeastJump); }

}  // namespace slam
