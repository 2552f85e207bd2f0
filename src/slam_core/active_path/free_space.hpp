// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/models/occupancy_grid.hpp"

namespace slam::active_path {

using Cell = std::uint32_t;  ///< index into OccupancyGrid::cells

/// Why a grid cannot be used (one clause); empty where it can.
std::string faultOf(const OccupancyGrid& grid);

/// What of a grid is known, and where a round robot has room. Thresholds are those of map_server:
/// at most 25 % is free, at least 65 % is occupied; what lies between is not known.
class FreeSpace {
 public:
  static constexpr std::int8_t kMostFree = 25, kLeastOccupied = 65;  // [%]

  /// @param grid without a fault, must outlive this
  /// @param robot_radius [m]
  FreeSpace(const OccupancyGrid& grid, double robot_radius);

  const OccupancyGrid& grid() const { return grid_; }
  bool isFree(Cell cell) const { return grid_.cells[cell] >= 0 && grid_.cells[cell] <= kMostFree; }
  bool isOccupied(Cell cell) const { return grid_.cells[cell] >= kLeastOccupied; }
  bool isKnown(Cell cell) const { return isFree(cell) || isOccupied(cell); }
  /// Whether the robot's centre may be there: the cell is free, and nothing occupied is within the
  /// radius.
  bool isPassable(Cell cell) const { return isFree(cell) && clearance_[cell] >= radius_; }
  /// From the cell's centre to the edge of the nearest occupied cell [m].
  double clearance(Cell cell) const { return clearance_[cell]; }

  bool contains(const Eigen::Vector2d& p_map) const;
  /// @param p_map [m], which the grid contains
  Cell cellAt(const Eigen::Vector2d& p_map) const;
  Eigen::Vector2d centre(Cell cell) const;  ///< [m]

  /// Calls visit(neighbour, is_diagonal) for the up to eight cells around one.
  template <class Visit>
  void forEachNeighbour(Cell cell, const Visit& visit) const {
    const auto x = static_cast<std::int64_t>(cell % grid_.width);
    const auto y = static_cast<std::int64_t>(cell / grid_.width);
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const bool is_inside =
            x + dx >= 0 && x + dx < grid_.width && y + dy >= 0 && y + dy < grid_.height;
        if ((dx == 0 && dy == 0) || !is_inside) continue;
        visit(static_cast<Cell>((y + dy) * grid_.width + x + dx), dx != 0 && dy != 0);
      }
  }

 private:
  const OccupancyGrid& grid_;
  double radius_;  ///< [m], less what rounding may take away
  std::vector<float> clearance_;
};

}  // namespace slam::active_path
