// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// What is known of a motion that nobody measured: that the robot goes on at its last velocity, and
/// within a quarter of a second may be at any velocity up to the largest it has had.
class Coasting {
 public:
  /// A motion that was measured; its velocity counts over a tenth of a second at least.
  void add(const Pose2& increment, Duration interval);

  Pose2 increment(Duration interval) const;
  /// Of (x, y, theta) of that increment [m^2, m rad, rad^2]; positive definite.
  Eigen::Matrix3d covariance(Duration interval) const;
  /// Whether a step is much longer than any of the motions that were measured.
  bool isUnusual(const Pose2& step, Duration interval) const;
  /// @return the largest speed of the motions that were measured [m/s]
  double largestSpeed() const { return largest_speed_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(step_, span_, velocity_, largest_speed_, largest_turn_rate_);
  }

 private:
  Pose2 step_;                                          ///< since the last velocity
  Duration span_{};                                     ///< of it
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< of the body [m/s, m/s, rad/s]
  double largest_speed_ = 0.0;                          ///< [m/s]
  double largest_turn_rate_ = 0.0;                      ///< [rad/s]
};

}  // namespace slam
