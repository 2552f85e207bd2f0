// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// The prior of a scan's pose.
struct PosePrior {
  Pose2 pose;                                             ///< T_map_base
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of (x, y, theta); 0: nothing
  /// If false, the pose is extrapolated from the last velocity. Then a scan corrects it also in
  /// directions in which the scan's information may only be noise of the surfaces' normals.
  bool is_measured = true;
  /// The same information relative to the older surfaces of the map, which the newest ones have
  /// drifted away from. Nothing if this is not known.
  std::optional<Eigen::Matrix3d> information_among_older = std::nullopt;
};

/// Where a scan fits a map.
struct Registration {
  Pose2 pose;                                             ///< T_map_base
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of the pose, from the scan alone
  int ends = 0;                                           ///< of beams that fit a surface
  double prior_weight = 1.0;                              ///< robust weight of the prior, 0 to 1
  bool isDetermined() const { return ends >= 5; }
};

/// Lessens a prior that the scan contradicts, in the direction of the contradiction alone: wheels
/// that slip sideways still tell how far a robot has come along a corridor.
/// @param found where the scan was found
/// @param weight the share that the prior keeps in this direction: Registration::prior_weight
/// @return the information that the prior keeps
Eigen::Matrix3d informationLeft(const PosePrior& prior, const Pose2& found, double weight);

/// Moves a scan from `start` to where its ends lie on the map's surfaces, by Gauss-Newton with the
/// prior as one more residual. Each end is matched with the nearest surface (Segal, Haehnel, Thrun
/// 2009). Its residuals are the distance across the surface and, where the surface is like a point,
/// the one along it, both over their variance. The kernel of Geman, McClure 1985 weighs them: an
/// end with a weight below 0.05, or without a surface within two cells, is ignored.
/// @param sigma standard deviation of an end's distance from what the beam met [m], in addition to
/// the laser's own noise
Registration registerScan(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                          const Pose2& start, const PosePrior& prior, double sigma);

/// An end of a beam that fits a surface of the map.
struct FittedEnd {
  Eigen::Vector2d surface;      ///< a point of it [m], in the map
  Eigen::Matrix3d information;  ///< of the robot's (x, y, theta), from this end
};

/// The ends that registerScan() uses at the pose where it has found the scan, and their shares of
/// its information. They err as they do there: the information of all together is larger than that
/// of the registration, which knows of noise that they share.
std::vector<FittedEnd> fittedEnds(const grid_map::GridMap& map, const grid_map::ScanPoints& scan,
                                  const Pose2& pose, double sigma);

}  // namespace slam::scan_matching
