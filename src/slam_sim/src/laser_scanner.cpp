// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/laser_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::sim {

namespace {

constexpr double kWhiteWall = 1000.0;     // intensity at 1 m
constexpr double kIntensityNoise = 0.05;  // relative

}  // namespace

LaserReadings LaserScanner::scan(const Pose2& T_world_base, RandomStream& random) const {
  const Pose2 T_base_laser(model_.position.x(), model_.position.y(), model_.yaw);
  const Pose2 T_world_laser = T_world_base * T_base_laser;
  LaserReadings readings;
  for (int beam = 0; beam < model_.beams; ++beam) {
    const double heading = T_world_laser.theta() + model_.angle(beam);
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    const auto end = plan_.rayEnd(T_world_laser.position(), direction, model_.position.z());
    readings.ranges.push_back(range(end.distance, random));
    if (plan_.hasReflectors()) readings.intensities.push_back(intensity(end, random));
  }
  return readings;
}

/// A number is drawn for every beam, so that no beam's noise depends on what the others hit.
float LaserScanner::range(double distance, RandomStream& random) const {
  const double noise = random.gaussian();
  if (!std::isfinite(distance)) return std::numeric_limits<float>::infinity();
  const double measured = distance * (1.0 + model_.relative_noise * noise);
  if (measured > model_.max_range) return std::numeric_limits<float>::infinity();
  if (measured < model_.min_range) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(measured);
}

/// It falls with the square of the distance, from reflectors as from all else.
float LaserScanner::intensity(const FloorPlan::RayEnd& end, RandomStream& random) {
  const double noise = random.gaussian();
  if (end.face == nullptr) return 0.0f;
  const double expected = kWhiteWall * end.face->brightness / (end.distance * end.distance);
  return static_cast<float>(std::max(0.0, expected * (1.0 + kIntensityNoise * noise)));
}

}  // namespace slam::sim
