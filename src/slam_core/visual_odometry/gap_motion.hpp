// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::visual_odometry {

/// The motion of an interval in which the images tell nothing.
struct GapMotion {
  Pose2 increment;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta) of the increment
};

/// Tells the motion between two stamps from another source; nothing where it does not cover them.
using GapSource = std::function<std::optional<GapMotion>(Stamp start, Stamp end)>;

}  // namespace slam::visual_odometry
