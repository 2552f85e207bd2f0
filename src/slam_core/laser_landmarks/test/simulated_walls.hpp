// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::test {

/// A straight wall that beams meet.
struct SimulatedWall {
  Eigen::Vector2d from, to;   // [m]
  double brightness = 100.0;  // intensity at 1 m; it falls with the square of the range
};

/// A room 8 m x 6 m around the origin.
inline std::vector<SimulatedWall> simulatedRoom() {
  const Eigen::Vector2d a(-4, -3), b(4, -3), c(4, 3), d(-4, 3);
  return {{a, b}, {b, c}, {c, d}, {d, a}};
}

/// A beam over the full circle in 720 that errs by these [m, rad].
struct WallLaser {
  double sigma_range = 0.0, sigma_bearing = 0.0;
  int beams = 720;
};

/// The range to a wall and its brightness; infinite where the beam misses it.
inline double rangeToWall(const SimulatedWall& wall, const Eigen::Vector2d& from,
                          const Eigen::Vector2d& ray) {
  Eigen::Matrix2d A;
  A << ray, wall.from - wall.to;
  const double determinant = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  if (std::abs(determinant) < 1e-12) return INFINITY;
  const Eigen::Vector2d b = wall.from - from;
  const double range = (b.x() * A(1, 1) - A(0, 1) * b.y()) / determinant;
  const double share = (A(0, 0) * b.y() - b.x() * A(1, 0)) / determinant;
  return range > 0.0 && share >= 0.0 && share <= 1.0 ? range : INFINITY;
}

inline LaserScan scanOfWalls(const std::vector<SimulatedWall>& walls, const Pose2& sensor,
                             const WallLaser& laser, RandomStream& random) {
  LaserScan scan;
  scan.sensor_frame = "laser";
  for (int i = 0; i < laser.beams; ++i) {
    const double bearing = 2.0 * M_PI * (i + 0.5) / laser.beams - M_PI;
    const double direction = sensor.theta() + bearing + laser.sigma_bearing * random.gaussian();
    const Eigen::Vector2d ray(std::cos(direction), std::sin(direction));
    double range = INFINITY, brightness = 0.0;
    for (const auto& wall : walls) {
      const double to_wall = rangeToWall(wall, sensor.position(), ray);
      if (to_wall >= range) continue;
      range = to_wall;
      brightness = wall.brightness;
    }
    const double measured = range + laser.sigma_range * random.gaussian();
    const bool hit = std::isfinite(measured);
    scan.beams.push_back({static_cast<float>(bearing), static_cast<float>(hit ? measured : 30.0),
                          hit, static_cast<float>(brightness / (range * range))});
  }
  return scan;
}

}  // namespace slam::test
