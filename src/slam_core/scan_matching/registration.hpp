// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// What is known of a scan's pose before it is matched.
struct PosePrior {
  Pose2 pose;                                             ///< T_map_base
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of (x, y, theta); 0: nothing
  bool is_measured = true;  ///< else it is a guess, and the least that a scan tells is better
};

/// Where a scan fits a map.
struct Registration {
  Pose2 pose;                                             ///< T_map_base
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< that the scan alone has of it
  int ends = 0;                                           ///< of beams that fit a surface
  double prior_weight = 1.0;  ///< what has been left of the prior, which the scan may contradict
  bool isDetermined() const { return ends >= 5; }
};

/// Moves a scan from `start` to where its ends lie on the map's surfaces: Gauss-Newton on the
/// distances across surfaces, with the prior's as one more. Each end goes with the nearest surface,
/// weighed by how noisy it is; those far from all count little (Segal, Haehnel, Thrun 2009;
/// Geman, McClure 1985).
/// @param sigma standard deviation of an end's distance from what it met [m], beside the laser's
/// own noise
Registration registerScan(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                          const Pose2& start, const PosePrior& prior, double sigma);

}  // namespace slam::scan_matching
