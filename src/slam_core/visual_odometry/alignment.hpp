// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/random.hpp"
#include "slam_core/visual_odometry/point_match.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// How an image lies to a reference.
struct Alignment {
  Pose2 T_reference_now;
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< of T_reference_now, matches independent
  PointMatches inliers;
  double scale = 1.0;  ///< of the ceiling's distance, reference over now
  std::string fault;   ///< empty, or the reason why it cannot be used, as it is counted
};

/// The rigid motion that most matches agree with: consensus on a similarity, whose scale must be 1,
/// then least squares with the scale fixed. Faults: "few_inliers", "scale".
Alignment align(const PointMatches& matches, const VisualOdometryConfig& config,
                RandomStream& random);

}  // namespace slam::visual_odometry
