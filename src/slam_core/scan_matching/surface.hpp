// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "slam_core/grid_map/grid_map.hpp"

namespace slam::scan_matching {

/// The surface that the ends of beams in neighbouring cells describe: a straight piece if they lie
/// along a line, otherwise a place with their spread. Lengths in cells.
struct Surface {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();    ///< mean of the ends
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< across it, of unit length
  double across = 0.0;                                ///< variance of the ends along the normal
  double along = 0.0;        ///< the same along it; infinite if it is a line
  bool is_isolated = false;  ///< of so few cells that it may go on unseen
  double tilt = 0.0;  ///< variance of the normal's direction, as the ends lie about a line [rad^2]

  bool goesOn() const { return std::isinf(along); }
};

/// Finds the surfaces of one map, and caches them: while a scan is being matched, its ends ask for
/// the same surface many times. The map must not change meanwhile.
class SurfaceFinder {
 public:
  explicit SurfaceFinder(const grid_map::GridMap& map) : map_(map), seen_(kSlots) {}

  /// The surface around the occupied cell nearest to a place [cells]; null if none is within two
  /// cells.
  const Surface* nearest(const Eigen::Vector2d& place);

 private:
  static constexpr std::size_t kSlots = 1 << 9;
  struct Slot {
    grid_map::CellIndex cell;
    bool is_taken = false;
    Surface surface;
  };

  const grid_map::GridMap& map_;
  std::vector<Slot> seen_;  ///< by cell; of two cells in one slot the later one
};

}  // namespace slam::scan_matching
