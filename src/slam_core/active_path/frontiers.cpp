// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/frontiers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::active_path {
namespace {

constexpr double kPieceLength = 1.0;  // [m]
constexpr Cell kNowhere = std::numeric_limits<Cell>::max();

/// For each free cell the reached cell that is the nearest through free cells, in rings around all
/// of them.
std::vector<Cell> viewpointsOf(const FreeSpace& space, const Ways& ways, double reach) {
  std::vector<Cell> viewpoints(space.grid().cells.size(), kNowhere), ring;
  for (Cell cell = 0; cell < viewpoints.size(); ++cell)
    if (ways.reaches(cell)) {
      viewpoints[cell] = cell;
      ring.push_back(cell);
    }
  for (double way = 0.0; way < reach && !ring.empty(); way += space.grid().resolution) {
    std::vector<Cell> next;
    for (const Cell cell : ring)
      space.forEachNeighbour(cell, [&](Cell neighbour, bool is_diagonal) {
        if (is_diagonal || viewpoints[neighbour] != kNowhere || !space.isFree(neighbour)) return;
        viewpoints[neighbour] = viewpoints[cell];
        next.push_back(neighbour);
      });
    ring = std::move(next);
  }
  return viewpoints;
}

/// Whether what is not known begins beside a cell; beyond the grid's edge nothing is.
bool isBesideUnknown(const FreeSpace& space, Cell cell) {
  std::size_t sides = 0;
  bool is_beside = false;
  space.forEachNeighbour(cell, [&](Cell neighbour, bool is_diagonal) {
    if (is_diagonal) return;
    ++sides;
    is_beside = is_beside || !space.isKnown(neighbour);
  });
  return is_beside || sides < 4;
}

std::vector<char> openCells(const FreeSpace& space, const std::vector<Cell>& viewpoints) {
  std::vector<char> open(viewpoints.size(), 0);
  for (Cell cell = 0; cell < viewpoints.size(); ++cell)
    open[cell] = viewpoints[cell] != kNowhere && isBesideUnknown(space, cell) ? 1 : 0;
  return open;
}

/// Takes connected cells from `open`, ring by ring around the first one.
std::vector<Cell> takePiece(const FreeSpace& space, Cell first, std::size_t most,
                            std::vector<char>& open) {
  std::vector<Cell> piece{first};
  open[first] = 0;
  for (std::size_t i = 0; i < piece.size(); ++i)
    space.forEachNeighbour(piece[i], [&](Cell neighbour, bool) {
      if (open[neighbour] == 0 || piece.size() >= most) return;
      open[neighbour] = 0;
      piece.push_back(neighbour);
    });
  return piece;
}

Cell middleOf(const FreeSpace& space, const std::vector<Cell>& cells) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Cell cell : cells) mean += space.centre(cell) / static_cast<double>(cells.size());
  return *std::min_element(cells.begin(), cells.end(), [&](Cell a, Cell b) {
    return (space.centre(a) - mean).squaredNorm() < (space.centre(b) - mean).squaredNorm();
  });
}

}  // namespace

std::vector<Frontier> frontiersOf(const FreeSpace& space, const Ways& ways, double robot_radius,
                                  double min_length) {
  const double resolution = space.grid().resolution;
  const auto viewpoints = viewpointsOf(space, ways, 3.0 * robot_radius);
  auto open = openCells(space, viewpoints);
  const auto most = static_cast<std::size_t>(
      std::ceil(std::max({kPieceLength, min_length, resolution}) / resolution));
  std::vector<Frontier> frontiers;
  for (Cell cell = 0; cell < open.size(); ++cell) {
    if (open[cell] == 0) continue;
    Frontier frontier;
    frontier.cells = takePiece(space, cell, most, open);
    if (static_cast<double>(frontier.cells.size()) * resolution < min_length) continue;
    frontier.middle = middleOf(space, frontier.cells);
    frontier.viewpoint = ways.before(viewpoints[frontier.middle], space.centre(frontier.middle),
                                     robot_radius + resolution);
    frontiers.push_back(std::move(frontier));
  }
  return frontiers;
}

}  // namespace slam::active_path
