// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/grid_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slam::relocalisation {
namespace {

constexpr double kNear = 0.2;          // [m]
constexpr std::int8_t kOccupied = 50;  // percent that an occupied cell exceeds

bool isNearSurface(const OccupancyGrid& grid, const Eigen::Vector2d& end) {
  const Eigen::Vector2d place = end - grid.origin;
  const auto first = [&](double along) {
    return std::max<std::int64_t>(0, std::llround((along - kNear) / grid.resolution - 0.5));
  };
  const auto last = [&](double along, std::uint32_t count) {
    return std::min<std::int64_t>(count - std::int64_t{1},
                                  std::llround((along + kNear) / grid.resolution - 0.5));
  };
  for (auto y = first(place.y()); y <= last(place.y(), grid.height); ++y)
    for (auto x = first(place.x()); x <= last(place.x(), grid.width); ++x)
      if (grid.cells[static_cast<std::size_t>(y * grid.width + x)] > kOccupied) return true;
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

}  // namespace slam::relocalisation
