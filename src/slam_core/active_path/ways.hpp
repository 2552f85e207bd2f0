// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "slam_core/active_path/free_space.hpp"

namespace slam::active_path {

/// The cell from which ways begin: the robot's own, or where it has no room there (too near to a
/// wall, in the blind zone of its laser) the nearest one that has, within two radii. Nothing where
/// there is none, or where the grid does not contain the position.
std::optional<Cell> startOf(const FreeSpace& space, const Eigen::Vector2d& p_map,
                            double robot_radius);

/// The cheapest ways through passable cells from one cell to all others (Dijkstra 1959). A metre
/// costs 1 m, beside a wall up to twice as much, so that ways keep their distance where there is
/// room.
class Ways {
 public:
  /// @param space must outlive this
  Ways(const FreeSpace& space, Cell start, double robot_radius);

  bool reaches(Cell cell) const { return cost_[cell] < kUnreached; }
  double cost(Cell cell) const { return cost_[cell]; }  ///< [m], of a cell that is reached
  /// From the start to a cell that is reached, cell by cell, both included [m].
  std::vector<Eigen::Vector2d> to(Cell cell) const;
  /// The last cell on the way to a cell that is reached that is at least `distance` from a place
  /// [m]; the start where there is none.
  Cell before(Cell cell, const Eigen::Vector2d& place, double distance) const;

 private:
  static constexpr float kUnreached = std::numeric_limits<float>::infinity();

  double stepCost(Cell cell, bool is_diagonal) const;
  bool cutsCorner(Cell from, Cell to) const;
  void search(Cell start);

  const FreeSpace& space_;
  double robot_radius_;
  std::vector<float> cost_;
  std::vector<Cell> previous_;
};

}  // namespace slam::active_path
