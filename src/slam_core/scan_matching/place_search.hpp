// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/scan_matching/likelihood_pyramid.hpp"

namespace slam::scan_matching {

/// Half the edge lengths of the box of poses in which a scan is searched.
struct SearchWindow {
  double position;  ///< [m]
  double heading;   ///< [rad]
};

/// Finds where a scan fits a map best in a window: the global maximum over all cells and headings
/// of the window, by branch and bound (Olson 2009; Hess, Kohler, Rapp, Andor 2016). The measure is
/// the likelihood of the scan's ends (Thrun, Burgard, Fox 2005, sec. 6.4, table 6.3) times a
/// Gaussian about the middle, whose sigmas are half the edges of the window.
class PlaceSearch {
 public:
  /// @param middle T_map_base. Nothing is found if the scan has no ends, or if this is no place on
  /// a map
  PlaceSearch(const grid_map::GridMap& map, const grid_map::ScanPoints& scan, const Pose2& middle,
              const SearchWindow& window);

  /// Whether the rasters need less than 70 MB. If they need more, nothing is found.
  static bool isWithinMemory(const grid_map::ScanPoints& scan, const SearchWindow& window);

  /// Whether there is something to search, and memory for it.
  bool isWithinReach() const { return pyramid_.has_value(); }
  /// T_map_base, to a cell.
  std::optional<Pose2> best() const;
  /// The best one among those that lie further from `place` than `apart` in position or in heading.
  std::optional<Pose2> bestApartFrom(const Pose2& place, const SearchWindow& apart) const;

 private:
  /// The scan taken from the middle, at one heading.
  struct Turned {
    double heading;  ///< beyond that of the middle [rad]
    int log_prior;
    std::vector<std::int32_t> ends;  ///< the cells that they fall in, as the pyramid counts
  };
  /// A square of shifts at one heading.
  struct Node {
    int bound = 0;  ///< nothing in it is better
    std::size_t turned = 0;
    std::int32_t x = 0, y = 0;  ///< the shift of its lower left corner [cells]
  };
  /// A region that is not searched.
  struct Exclusion {
    double x, y, heading;  ///< beyond the middle [cells, cells, rad]
    double radius, angle;  ///< [cells], [rad]
  };

  std::vector<std::vector<grid_map::CellIndex>> turn(const grid_map::ScanPoints& scan);
  std::optional<Pose2> search(const std::optional<Exclusion>& exclusion) const;
  /// Searches the cells below a node as long as they may be better than the best so far.
  void descend(const Node& node, int level, const std::optional<Exclusion>& exclusion,
               Node& best) const;
  bool isWithin(const Node& node, int level, const Exclusion& exclusion) const;
  /// @param enough the sum is not completed once it falls to this value
  int boundOf(const Node& node, int level, int enough) const;

  Pose2 middle_;
  SearchWindow window_;
  double cells_per_metre_;
  std::int32_t reach_;  ///< [cells]
  std::array<int, 256> logs_;
  std::vector<Turned> turned_;
  std::optional<LikelihoodPyramid> pyramid_;
};

}  // namespace slam::scan_matching
