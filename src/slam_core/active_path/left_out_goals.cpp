// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/left_out_goals.hpp"

#include <algorithm>

namespace slam::active_path {

void LeftOutGoals::leaveForAWhile(const Eigen::Vector2d& place, Stamp now) {
  const bool is_second = std::any_of(goals_.begin(), goals_.end(),
                                     [&](const Goal& goal) { return isNear(goal, place); });
  goals_.push_back({place, is_second, now + time_});
}

bool LeftOutGoals::contains(const Eigen::Vector2d& place, Stamp now) const {
  return std::any_of(goals_.begin(), goals_.end(), [&](const Goal& goal) {
    return (goal.is_for_good || now < goal.until) && isNear(goal, place);
  });
}

bool LeftOutGoals::isAnyWaiting(Stamp now) const {
  return std::any_of(goals_.begin(), goals_.end(), [&](const Goal& goal) {
    return !goal.is_for_good && now < goal.until && !isLeftForGood(goal.place);
  });
}

bool LeftOutGoals::isLeftForGood(const Eigen::Vector2d& place) const {
  return std::any_of(goals_.begin(), goals_.end(),
                     [&](const Goal& goal) { return goal.is_for_good && isNear(goal, place); });
}

}  // namespace slam::active_path
