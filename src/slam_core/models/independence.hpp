// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// Observations in quick succession show the same and have the same errors. An observation is
/// independent of the last one after this distance, this turn or this time.
struct Independence {
  double distance, turn;                                  ///< [m], [rad]
  double time = std::numeric_limits<double>::infinity();  ///< [s]

  /// @return the weight of an observation, in independent ones; 1 at most
  double weightOf(const Pose2& step, Duration since_last) const {
    return std::min(1.0, step.position().norm() / distance + std::abs(step.theta()) / turn +
                             std::max(0.0, seconds(since_last)) / time);
  }
};

}  // namespace slam
