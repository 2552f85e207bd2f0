// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/grid_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slam::relocalisation {
namespace {

constexpr double kNearSurface = 0.2;   // [m]
constexpr std::int8_t kOccupied = 50;  // percent that an occupied cell exceeds

/// The cells along an axis whose middles are near a place.
struct Span {
  std::int64_t first, last;

  /// @param place from the grid's edge [m] @param count cells along the axis
  static Span near(double place, double resolution, std::uint32_t count) {
    const auto cell = [&](double at) {
      return static_cast<std::int64_t>(std::floor(at / resolution));
    };
    return {std::max<std::int64_t>(0, cell(place - kNearSurface)),
            std::min<std::int64_t>(std::int64_t{count} - 1, cell(place + kNearSurface))};
  }
};

bool isNearSurface(const OccupancyGrid& grid, const Eigen::Vector2d& end) {
  const Eigen::Vector2d place = end - grid.origin;
  const auto rows = Span::near(place.y(), grid.resolution, grid.height);
  const auto columns = Span::near(place.x(), grid.resolution, grid.width);
  for (auto y = rows.first; y <= rows.last; ++y)
    for (auto x = columns.first; x <= columns.last; ++x) {
      if (grid.cells[static_cast<std::size_t>(y * grid.width + x)] <= kOccupied) continue;
      const Eigen::Vector2d middle =
          grid.resolution * Eigen::Vector2d(double(x) + 0.5, double(y) + 0.5);
      if ((middle - place).norm() <= kNearSurface + 0.5 * grid.resolution) return true;
    }
  return false;
}

}  // namespace

double shareOnSurfaces(const OccupancyGrid& grid, const LaserScan& scan, const Pose2& robot) {
  std::size_t hits = 0, near = 0;
  forEachFan(scan, [&](const LaserFan& fan) {
    const Pose2 laser = robot * fan.sensor_pose;
    for (const auto& beam : fan.beams) {
      if (!beam.hit) continue;
      ++hits;
      near += isNearSurface(grid, laser.transform(beam.end())) ? 1 : 0;
    }
  });
  return hits == 0 ? 0.0 : static_cast<double>(near) / static_cast<double>(hits);
}

double bestShareOnSurfaces(const OccupancyGrid& grid, const LaserScan& scan, const Pose2& robot) {
  constexpr double kStep = 0.2, kTurn = 0.05;  // [m], [rad]
  double best = 0.0;
  for (int turn = -8; turn <= 8; ++turn)
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        best = std::max(
            best, shareOnSurfaces(grid, scan, robot * Pose2(kStep * x, kStep * y, kTurn * turn)));
  return best;
}

}  // namespace slam::relocalisation
