// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/beam_reading.hpp"

namespace slam::scan_matching {
namespace {

using grid_map::CellIndex;
using grid_map::GridMap;
using grid_map::Tile;

constexpr std::int32_t kReach = 2;      // cells on either side, for the nearest and for its line
constexpr int kFewestOfLine = 3;        // cells
constexpr double kStretchOfLine = 4.0;  // of a line, variance along over variance across
constexpr double kOffsets = 256.0;      // of a mean, in a cell

/// Calls visit(mean) for the ends' mean of each occupied cell around one.
template <class Visit>
void forOccupied(const GridMap& map, CellIndex middle, const Visit& visit) {
  const Tile* tile = nullptr;
  CellIndex of{std::numeric_limits<std::int32_t>::min(), 0};
  for (std::int32_t y = middle.y - kReach; y <= middle.y + kReach; ++y)
    for (std::int32_t x = middle.x - kReach; x <= middle.x + kReach; ++x) {
      const CellIndex in_tiles{x >> Tile::kBits, y >> Tile::kBits};
      if (!(in_tiles == of)) {
        of = in_tiles;
        tile = map.tile({x, y});
      }
      if (tile == nullptr) continue;
      const auto at = Tile::at({x, y});
      if (!grid_map::BeamModel::isOccupied(tile->log_odds[at])) continue;
      visit(CellIndex{x, y}, Eigen::Vector2d(x + 0.5 + tile->mean_x[at] / kOffsets,
                                             y + 0.5 + tile->mean_y[at] / kOffsets));
    }
}

std::optional<CellIndex> nearestOccupied(const GridMap& map, const Eigen::Vector2d& place) {
  std::optional<CellIndex> best;
  double least = std::numeric_limits<double>::infinity();
  forOccupied(map, grid_map::cellOf(place), [&](CellIndex cell, const Eigen::Vector2d& mean) {
    const double squared = (mean - place).squaredNorm();
    if (squared >= least) return;
    least = squared;
    best = cell;
  });
  return best;
}

Surface surfaceAbout(const GridMap& map, CellIndex middle) {
  int count = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), own = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d origin(middle.x, middle.y);
  forOccupied(map, middle, [&](CellIndex cell, const Eigen::Vector2d& mean) {
    const Eigen::Vector2d offset = mean - origin;
    if (cell == middle) own = offset;
    ++count;
    sum += offset;
    squares += offset * offset.transpose();
  });
  Surface surface;
  if (count < kFewestOfLine) {
    surface.point = origin + own;  // of something that may go on unseen, as far as looked at
    surface.across = surface.along = kReach * kReach;
    return surface;
  }
  const Eigen::Vector2d mean = sum / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(squares / count - mean * mean.transpose());
  surface.point = origin + mean;
  surface.normal = axes.eigenvectors().col(0);
  surface.across = std::max(0.0, axes.eigenvalues()(0));
  surface.along = axes.eigenvalues()(1);
  if (surface.along > kStretchOfLine * surface.across) {
    surface.tilt = surface.across / ((count - 2) * surface.along);  // of a line's slope
    surface.along = std::numeric_limits<double>::infinity();
  }
  return surface;
}

}  // namespace

const Surface* SurfaceFinder::nearest(const Eigen::Vector2d& place) {
  const auto cell = nearestOccupied(map_, place);
  if (!cell) return nullptr;
  constexpr std::uint32_t kFactorX = 73856093, kFactorY = 19349663;
  const auto key = static_cast<std::uint32_t>(cell->x) * kFactorX ^
                   static_cast<std::uint32_t>(cell->y) * kFactorY;
  auto& slot = seen_[key % kSlots];
  if (!slot.is_taken || !(slot.cell == *cell)) slot = {*cell, true, surfaceAbout(map_, *cell)};
  return &slot.surface;
}

}  // namespace slam::scan_matching
