// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::scan_matching {

constexpr double kSpacing = 0.05;  ///< of a scan's points that are matched [m]

/// @param sigma of each coordinate of the pose [m], [rad]
inline PosePrior priorAt(const Pose2& pose, double sigma) {
  return {pose, Eigen::Matrix3d(Eigen::Matrix3d::Identity() / (sigma * sigma))};
}

}  // namespace slam::scan_matching
