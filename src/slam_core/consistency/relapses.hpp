// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// If a robot is lost again soon after it was found, it was found at a wrong place: the map is no
/// longer true, or several places look alike. The next place may be wrong as well. So it is on
/// probation for one second, and for twice as long after each further relapse (exponential
/// backoff). If the robot was always found within half a metre of where it was, it has not moved:
/// after kHopeless relapses the map must have changed. All that was learnt meanwhile agrees with
/// the place at which the robot was found, so that time proves nothing, and only somebody who sets
/// the pose ends the doubt.
class Relapses {
 public:
  static constexpr int kHopeless = 4;

  /// To be called after each step.
  void judge(bool is_lost, const Eigen::Vector2d& robot, Stamp stamp);
  /// Whether the robot was found, and the place is not yet confirmed.
  bool isOnProbation() const { return on_probation_until_.has_value(); }
  int count() const { return count_; }
  /// @return the largest jump with which the robot was found, at least half a metre [m]
  double extent() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(is_lost_, count_, largest_jump_, robot_, found_, on_probation_until_);
  }

 private:
  void lose(Stamp stamp);
  void find(const Eigen::Vector2d& robot, Stamp stamp);

  bool is_lost_ = false;
  int count_ = 0;              ///< of relapses, one soon after the other
  double largest_jump_ = 0.0;  ///< with which the robot was found, since the first relapse [m]
  Eigen::Vector2d robot_ = Eigen::Vector2d::Zero();  ///< after the last step
  std::optional<Stamp> found_;                       ///< the last time
  std::optional<Stamp> on_probation_until_;
};

}  // namespace slam
