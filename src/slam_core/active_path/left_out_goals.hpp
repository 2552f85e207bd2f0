// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/common/time.hpp"

namespace slam::active_path {

/// Goals that are not to be chosen again: for a while those that were not reached, for good those
/// that were not reached a second time, and those from which the robot has seen all that it can.
class LeftOutGoals {
 public:
  /// @param radius what is so near to a goal is left out with it [m]
  /// @param time for how long, the first time
  LeftOutGoals(double radius, Duration time) : radius_(radius), time_(time) {}

  void leaveForAWhile(const Eigen::Vector2d& place, Stamp now);
  void leaveForGood(const Eigen::Vector2d& place) { goals_.push_back({place, true, {}}); }
  void clear() { goals_.clear(); }

  bool contains(const Eigen::Vector2d& place, Stamp now) const;
  /// Whether some will be chosen from again.
  bool isAnyWaiting(Stamp now) const;

 private:
  struct Goal {
    Eigen::Vector2d place;
    bool is_for_good;
    Stamp until;
  };

  bool isNear(const Goal& goal, const Eigen::Vector2d& place) const {
    return (goal.place - place).norm() <= radius_;
  }

  bool isLeftForGood(const Eigen::Vector2d& place) const;

  double radius_;
  Duration time_;
  std::vector<Goal> goals_;
};

}  // namespace slam::active_path
