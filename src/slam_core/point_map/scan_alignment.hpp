// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/models/laser_scan.hpp"
#include "slam_core/point_map/point_map_config.hpp"
#include "slam_core/point_map/point_set.hpp"
#include "slam_core/point_map/surface_line.hpp"

namespace slam::point_map {

/// Aligns a scan to a map of points: each end point is drawn to the line through the map's points
/// around the nearest one (Censi 2008), far ones with less weight, and all of it weakly to the
/// filter's pose, which counts where the surfaces tell nothing (a corridor).
class ScanAlignment {
 public:
  explicit ScanAlignment(const PointMapConfig& config) : config_(config) {}

  /// @param guess T_map_base where the search begins
  /// @param prior T_map_base by the filter
  /// @return the aligned pose; nothing where too little of the scan meets the map
  std::optional<Pose2> align(const LaserScan& scan, const Pose2& guess, const Pose2& prior,
                             const PointSet& map);

 private:
  /// Sums of the weighted least squares: H delta = b, of (x, y, heading about the robot).
  struct NormalEquations {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    std::size_t matched = 0;
  };

  NormalEquations compare(const Pose2& T_map_base, double radius, const PointSet& map);
  void addPrior(const Pose2& T_map_base, const Pose2& prior, NormalEquations& sums) const;
  const SurfaceLine& lineAt(std::uint32_t point, const PointSet& map);

  PointMapConfig config_;
  std::vector<Eigen::Vector2d> ends_;  ///< of the scan in hand, in the base frame
  std::unordered_map<std::uint32_t, SurfaceLine> lines_;  ///< of the scan in hand, by map point
};

}  // namespace slam::point_map
