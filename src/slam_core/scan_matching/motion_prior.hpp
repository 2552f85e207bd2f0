// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/scan_matching/registration.hpp"

namespace slam::scan_matching {

/// What is known of a scan's pose from that of the scan before and the motion in between. Wheels do
/// worse things than their covariance says: they slip, and a lurch of a second belongs to no
/// Gaussian. So the prior is widened by a slip: a fifth of the way and of the turn, a tenth of each
/// to the other (by metre and radian), and 2 cm and 0.02 rad. That costs little where scans tell
/// the pose to a centimetre.
/// @param covariance of `before`, in (x, y, theta)
/// @param noise of the increment, in its coordinates
PosePrior priorAfter(const Pose2& before, const Eigen::Matrix3d& covariance, const Pose2& increment,
                     const Eigen::Matrix3d& noise);

}  // namespace slam::scan_matching
