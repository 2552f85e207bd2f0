// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::graph_slam {

/// Finds scans anywhere in a map whose scans all lie where they belong: nothing is known of the
/// robot but that it may be somewhere in there. One search takes some ten milliseconds.
class ScanRecogniser {
 public:
  ScanRecogniser(const grid_map::GridMapConfig& grid, const scan_matching::MatcherConfig& matcher);

  /// Draws a scan where `grid_map.largest_memory` leaves room for it. @param pose T_map_base
  void draw(const LaserScan& scan, const Pose2& pose);
  /// @return the only place that explains most of the scan; nothing where it fits nowhere, or about
  /// as well elsewhere
  std::optional<scan_matching::Match> find(const LaserScan& scan) const;

 private:
  grid_map::GridMapConfig config_;
  scan_matching::LevelModels models_;
  double spacing_;
  scan_matching::ScanToMapMatcher matcher_;
  scan_matching::ScanMap map_;
  Eigen::AlignedBox2d places_;  ///< where scans were taken [m]
};

}  // namespace slam::graph_slam
