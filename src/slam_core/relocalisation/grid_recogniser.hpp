// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "slam_core/relocalisation/local_scans.hpp"
#include "slam_core/relocalisation/recognition.hpp"
#include "slam_core/relocalisation/relocalisation_config.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::relocalisation {

/// Recognises the place of a robot in a grid by what its laser has seen on the last metres. Parts
/// of a building look alike, so that a place is confirmed only when two searches, between which the
/// robot has driven a metre, have led to it and none in between has led elsewhere.
class GridRecogniser {
 public:
  GridRecogniser(const RelocalisationConfig& config, const grid_map::GridMapConfig& grid,
                 const scan_matching::MatcherConfig& matcher);

  void move(const Motion& motion) { local_.move(motion); }
  void see(const LaserScan& scan);
  void forget();

  /// Whether the grid has cells, and is small enough to be searched as a whole.
  static bool canSearch(const OccupancyGrid& grid);
  /// Starts to look for the robot in this grid, for which canSearch() holds.
  void begin(const OccupancyGrid& grid);
  void end() { map_.reset(); }
  /// Makes the next find() search even if the robot has not moved.
  void searchAnyway() { is_due_ = true; }
  /// To be called between begin() and end(). A search takes some hundredths of a second.
  /// @return nothing where the robot has not moved far enough since the last search
  std::optional<Recognition> find();
  /// Radius of a circle that holds the grid [m]; 0 where there is none to search.
  double radius() const { return map_ ? 0.5 * box_.diagonal().norm() : 0.0; }

 private:
  /// The transform between map and local scans that a search has found.
  struct Found {
    Pose2 map_local;  ///< T_map_local
    double way;       ///< distance that the robot had driven by then [m]
  };

  bool isDue() const;
  bool confirms(const Pose2& place);

  RelocalisationConfig config_;
  grid_map::GridMapConfig grid_config_;
  scan_matching::ScanToMapMatcher matcher_;
  LocalScans local_;
  std::unique_ptr<scan_matching::ScanMap> map_;  ///< the grid, while it is searched
  Eigen::AlignedBox2d box_;                      ///< of the map [m]
  std::optional<Found> first_;                   ///< not contradicted by later searches
  double searched_ = 0.0;                        ///< distance driven at the last search [m]
  bool is_due_ = false, has_news_ = false;
};

}  // namespace slam::relocalisation
