// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "slam_core/grid_map/grid_map.hpp"

namespace slam::scan_matching {

/// What the ends of beams in neighbouring cells say of what stands there: a straight piece of a
/// surface where they lie along a line, else a place with their spread. Lengths in cells.
struct Surface {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();    ///< mean of the ends
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< across it, of unit length
  double across = 0.0;                                ///< variance of the ends along the normal
  double along = 0.0;                                 ///< the same along it; infinite for a line
  double tilt = 0.0;  ///< variance of the normal's direction, as the ends lie about a line [rad^2]

  bool goesOn() const { return std::isinf(along); }
};

/// Finds the surfaces of one map. It remembers those that it has looked at: of a scan that is moved
/// about, an end asks for the same one many times. The map must not change meanwhile.
class SurfaceFinder {
 public:
  explicit SurfaceFinder(const grid_map::GridMap& map) : map_(map), seen_(kSlots) {}

  /// The surface about the occupied cell that is nearest to a place [cells]; null where none is
  /// within two cells.
  const Surface* nearest(const Eigen::Vector2d& place);

 private:
  static constexpr std::size_t kSlots = 1 << 9;
  struct Slot {
    grid_map::CellIndex cell;
    bool is_taken = false;
    Surface surface;
  };

  const grid_map::GridMap& map_;
  std::vector<Slot> seen_;  ///< by cell; of two in one slot the later
};

}  // namespace slam::scan_matching
