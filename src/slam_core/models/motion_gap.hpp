// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/motion.hpp"

namespace slam {

/// Bridges the gap that lost messages leave between an odometry's motions. Where the robot went in
/// it the odometry's poses tell, which each motion carries; how surely they do not, so that it is
/// taken to have erred all the while as in its worst increment so far.
class MotionGap {
 public:
  /// @return whether some are missing before this motion, which now begins where the last one
  /// ended; one that is older than the last one is left alone
  bool bridge(Motion& motion);

  void reset() { *this = {}; }

 private:
  Motion across(const Motion& before, const Motion& after) const;

  std::optional<Motion> last_;
  Eigen::Matrix3d worst_rate_ = Eigen::Matrix3d::Zero();  ///< covariance in a second
};

}  // namespace slam
