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

/// Calls visit(cell, mean, ends) for each occupied cell around one, with the number of ends that
/// the mean is of.
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
      visit(CellIndex{x, y},
            Eigen::Vector2d(x + 0.5 + tile->mean_x[at] / kOffsets,
                            y + 0.5 + tile->mean_y[at] / kOffsets),
            tile->ends[at]);
    }
}

std::optional<CellIndex> nearestOccupied(const GridMap& map, const Eigen::Vector2d& place) {
  std::optional<CellIndex> best;
  double least = std::numeric_limits<double>::infinity();
  forOccupied(map, grid_map::cellOf(place), [&](CellIndex cell, const Eigen::Vector2d& mean, int) {
    const double squared = (mean - place).squaredNorm();
    if (squared >= least) return;
    least = squared;
    best = cell;
  });
  return best;
}

/// Of the means of cells. A cell counts by how many ends it has: beside a wall stand cells in which
/// a few ends fell that were measured too long, and that no beam has passed since.
class Moments {
 public:
  void add(const Eigen::Vector2d& mean, int ends) {
    const double weight = std::max(1, ends);
    ++cells_;
    weights_ += weight;
    squared_weights_ += weight * weight;
    sum_ += weight * mean;
    squares_ += weight * mean * mean.transpose();
  }
  int cells() const { return cells_; }
  /// As many cells, were all alike, tell as much.
  double effectiveCells() const { return weights_ * weights_ / squared_weights_; }
  Eigen::Vector2d mean() const { return sum_ / weights_; }
  Eigen::Matrix2d covariance() const { return squares_ / weights_ - mean() * mean().transpose(); }

 private:
  int cells_ = 0;
  double weights_ = 0.0, squared_weights_ = 0.0;
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

Surface surfaceAbout(const GridMap& map, CellIndex middle) {
  Moments moments;
  const Eigen::Vector2d origin(middle.x, middle.y);
  Surface surface;
  forOccupied(map, middle, [&](CellIndex cell, const Eigen::Vector2d& mean, int ends) {
    if (cell == middle) surface.point = mean;
    moments.add(mean - origin, ends);
  });
  surface.is_isolated = moments.cells() < kFewestOfLine;
  if (surface.is_isolated) {  // a part of what may go on unseen, as far as was looked
    surface.across = surface.along = kReach * kReach;
    return surface;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(moments.covariance());
  surface.point = origin + moments.mean();
  surface.normal = axes.eigenvectors().col(0);
  surface.across = std::max(0.0, axes.eigenvalues()(0));
  surface.along = axes.eigenvalues()(1);
  if (surface.along > kStretchOfLine * surface.across) {
    surface.tilt = surface.across / (std::max(1.0, moments.effectiveCells() - 2.0) * surface.along);
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
