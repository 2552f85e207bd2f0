// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/relapses.hpp"

#include <algorithm>

namespace slam {
namespace {

/// A place at which the robot has been for so long without being lost was right.
constexpr Duration kSoon = std::chrono::seconds(15);

/// For how long the robot must stay found after so many relapses, of which there is still hope.
Duration probationAfter(int relapses) {
  return std::chrono::seconds(1) * (1 << std::min(relapses - 1, Relapses::kHopeless));
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
      count_ >= kHopeless ||
      (found_ && (stamp - *found_ < kSoon || stamp - *found_ < 2 * probationAfter(count_ + 1)));
  count_ = is_soon ? count_ + 1 : 0;
  if (!is_soon) largest_jump_ = 0.0;
  on_probation_until_.reset();
}

void Relapses::find(const Eigen::Vector2d& robot, Stamp stamp) {
  largest_jump_ = std::max(largest_jump_, (robot - robot_).norm());
  found_ = stamp;
  if (count_ >= kHopeless)
    on_probation_until_ = Stamp::max();
  else if (count_ > 0)
    on_probation_until_ = stamp + probationAfter(count_);
}

double Relapses::extent() const {
  constexpr double kLeast = 0.5;
  return std::max(largest_jump_, kLeast);
}

}  // namespace slam
