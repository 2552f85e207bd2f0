// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/archive.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/point_map/point_map_config.hpp"
#include "slam_core/point_map/point_set.hpp"

namespace slam::point_map {

/// How a scan gets into the map.
class FusionPolicy {
 public:
  virtual ~FusionPolicy() = default;
  /// The pose at which the scan's end points are to be fused with the map.
  /// @param T_map_base by the filter
  virtual Pose2 place(const LaserScan& scan, const Pose2& T_map_base, const PointSet& map) = 0;
  /// The point that an end point of the scan placed last is to be fused with; none: it is a new
  /// one. May join points of the map, which changes the indices of others (PointSet::join).
  virtual std::optional<std::uint32_t> match(const Eigen::Vector2d& end, PointSet& map) = 0;
  /// The map starts over.
  virtual void reset() {}
  /// What it knows of the scans before, for who has some.
  virtual void saveState(ArchiveWriter& /*archive*/) const {}
  virtual void restoreState(ArchiveReader& /*archive*/) {}
};

/// The thesis's: at the filter's pose, as it is (5.6).
std::unique_ptr<FusionPolicy> makeEuclideanFusion(const PointMapConfig& config);
/// The scan is aligned to the map first; across a surface that the map knows well, end points fuse
/// from farther.
std::unique_ptr<FusionPolicy> makeAlignedFusion(const PointMapConfig& config);

/// @param config checked
std::unique_ptr<FusionPolicy> makeFusion(const PointMapConfig& config);

}  // namespace slam::point_map
