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
  /// false: the pose is extrapolated from the last velocity. Then a scan also corrects it in
  /// directions in which its information may be noise of the surfaces' normals.
  bool is_measured = true;
};

/// Where a scan fits a map.
struct Registration {
  Pose2 pose;                                             ///< T_map_base
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< that the scan alone has of it
  int ends = 0;                                           ///< of beams that fit a surface
  double prior_weight = 1.0;                              ///< robust weight of the prior, 0 to 1
  bool isDetermined() const { return ends >= 5; }
};

/// Moves a scan from `start` to where its ends lie on the map's surfaces, by Gauss-Newton with the
/// prior as one more residual. Each end is matched with the nearest surface (Segal, Haehnel, Thrun
/// 2009). Its residuals are the distance across the surface and, where the surface is like a point,
/// the one along it, both over their variance. The kernel of Geman, McClure 1985 weighs them: an
/// end with a weight below 0.05, or without a surface within two cells, is ignored.
/// @param sigma standard deviation of an end's distance from what it met [m], beside the laser's
/// own noise
Registration registerScan(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                          const Pose2& start, const PosePrior& prior, double sigma);

}  // namespace slam::scan_matching
