// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::test {

/// A trunk that beams meet.
struct Tree {
  Eigen::Vector2d position;
  double radius;  // [m]
};

/// To the first trunk in a direction [m]; infinite where there is none.
inline double rangeToTrees(const std::vector<Tree>& trees, const Eigen::Vector2d& from,
                           double direction) {
  const Eigen::Vector2d ray(std::cos(direction), std::sin(direction));
  double nearest = INFINITY;
  for (const auto& tree : trees) {
    const Eigen::Vector2d to_tree = tree.position - from;
    const double along = to_tree.dot(ray);
    const double half_chord2 = tree.radius * tree.radius - to_tree.squaredNorm() + along * along;
    if (along > 0.0 && half_chord2 > 0.0)
      nearest = std::min(nearest, along - std::sqrt(half_chord2));
  }
  return nearest;
}

/// How the simulated laser errs and sees: over 180 degrees ahead in 361 beams.
struct TreeLaser {
  double sigma_range = 0.0, sigma_bearing = 0.0;  // [m, rad]
  double reach = 80.0;                            // [m]
  int beams = 361;
  Pose2 mount = Pose2();  // T_base_sensor
};

inline LaserScan scanOfTrees(const std::vector<Tree>& trees, const Pose2& base,
                             const TreeLaser& laser, RandomStream& random) {
  const Pose2 sensor = base * laser.mount;
  LaserScan scan;
  scan.sensor_frame = "laser";
  scan.sensor_pose = laser.mount;
  for (int i = 0; i < laser.beams; ++i) {
    const double bearing = M_PI * (static_cast<double>(i) / (laser.beams - 1) - 0.5);
    const double direction = sensor.theta() + bearing + laser.sigma_bearing * random.gaussian();
    const double range =
        rangeToTrees(trees, sensor.position(), direction) + laser.sigma_range * random.gaussian();
    const bool hit = range < laser.reach;
    scan.beams.push_back(
        {static_cast<float>(bearing), static_cast<float>(hit ? range : laser.reach), hit});
  }
  return scan;
}

}  // namespace slam::test
