// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/laser_scanner.hpp"

#include <cmath>
#include <limits>

namespace slam::sim {

std::vector<float> LaserScanner::scan(const Pose2& T_world_base, RandomStream& random) const {
  const Pose2 T_base_laser(model_.position.x(), model_.position.y(), model_.yaw);
  const Pose2 T_world_laser = T_world_base * T_base_laser;
  std::vector<float> ranges;
  for (int beam = 0; beam < model_.beams; ++beam) {
    const double heading = T_world_laser.theta() + model_.angle(beam);
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    ranges.push_back(
        range(plan_.rayCast(T_world_laser.position(), direction, model_.position.z()), random));
  }
  return ranges;
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

}  // namespace slam::sim
