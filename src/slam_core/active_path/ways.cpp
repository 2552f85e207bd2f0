// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/ways.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace slam::active_path {

std::optional<Cell> startOf(const FreeSpace& space, const Eigen::Vector2d& p_map,
                            double robot_radius) {
  if (!space.contains(p_map)) return {};
  const Cell own = space.cellAt(p_map);
  if (space.isPassable(own)) return own;
  const double reach = 2.0 * robot_radius;
  const auto& grid = space.grid();
  const auto cells = static_cast<std::int64_t>(reach / grid.resolution) + 1;
  std::optional<Cell> nearest;
  double least = reach;
  for (std::int64_t dy = -cells; dy <= cells; ++dy)
    for (std::int64_t dx = -cells; dx <= cells; ++dx) {
      const std::int64_t x = own % grid.width + dx, y = own / grid.width + dy;
      if (x < 0 || y < 0 || x >= grid.width || y >= grid.height) continue;
      const auto cell = static_cast<Cell>(y * grid.width + x);
      const double distance = (space.centre(cell) - p_map).norm();
      if (distance >= least || !space.isPassable(cell)) continue;
      nearest = cell;
      least = distance;
    }
  return nearest;
}

Ways::Ways(const FreeSpace& space, Cell start, double robot_radius)
    : space_(space),
      robot_radius_(robot_radius),
      cost_(space.grid().cells.size(), kUnreached),
      previous_(space.grid().cells.size(), start) {
  search(start);
}

void Ways::search(Cell start) {
  using Entry = std::pair<float, Cell>;  // the cell as well decides, so that the order is one
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_[start] = 0.0F;
  open.emplace(0.0F, start);
  while (!open.empty()) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost > cost_[cell]) continue;
    space_.forEachNeighbour(cell, [&, from = cell, so_far = cost](Cell next, bool is_diagonal) {
      if (!space_.isPassable(next) || (is_diagonal && cutsCorner(from, next))) return;
      const auto cost_there = static_cast<float>(so_far + stepCost(next, is_diagonal));
      if (cost_there >= cost_[next]) return;
      cost_[next] = cost_there;
      previous_[next] = from;
      open.emplace(cost_there, next);
    });
  }
}

double Ways::stepCost(Cell cell, bool is_diagonal) const {
  const double length = (is_diagonal ? std::sqrt(2.0) : 1.0) * space_.grid().resolution;
  const double room = (space_.clearance(cell) - robot_radius_) / robot_radius_;
  return length * (1.0 + std::clamp(1.0 - room, 0.0, 1.0));
}

/// Whether a diagonal step passes between two cells of which one is not passable.
bool Ways::cutsCorner(Cell from, Cell to) const {
  const Cell width = space_.grid().width;
  const Cell beside = from / width * width + to % width;
  const Cell above = to / width * width + from % width;
  return !space_.isPassable(beside) || !space_.isPassable(above);
}

std::vector<Eigen::Vector2d> Ways::to(Cell cell) const {
  std::vector<Eigen::Vector2d> way{space_.centre(cell)};
  while (cost_[cell] > 0.0F) {
    cell = previous_[cell];
    way.push_back(space_.centre(cell));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

Cell Ways::before(Cell cell, const Eigen::Vector2d& place, double distance) const {
  while (cost_[cell] > 0.0F && (space_.centre(cell) - place).norm() < distance)
    cell = previous_[cell];
  return cell;
}

}  // namespace slam::active_path
