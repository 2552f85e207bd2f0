// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::point_map::test {

struct Wall {
  Eigen::Vector2d from, to;
};

/// A rectangular room with its corner at the origin and a box in it, seen by a laser.
class Room {
 public:
  Room(double width, double depth) {
    addBox({0, 0}, {width, depth});
    addBox({0.45 * width, 0.8 * depth}, {0.5 * width, 0.9 * depth});
  }
  const std::vector<Wall>& walls() const { return walls_; }

  /// 360 beams all around, up to 8 m; the laser sits 0.1 m ahead of the robot's middle.
  LaserScan scan(const Pose2& T_map_base, double sigma = 0.0,
                 RandomStream* random = nullptr) const {
    LaserScan scan;
    scan.sensor_pose = {0.1, 0, 0};
    const Pose2 T_map_sensor = T_map_base * scan.sensor_pose;
    for (int i = 0; i < 360; ++i) {
      const double bearing = (i - 180) * M_PI / 180;
      double range = rangeAt(T_map_sensor, bearing);
      const bool hit = range < 8.0;
      if (hit && random != nullptr) range += sigma * random->gaussian();
      scan.beams.push_back(
          {static_cast<float>(bearing), static_cast<float>(hit ? range : 8.0), hit});
    }
    return scan;
  }

  /// Of a point to the nearest wall [m].
  double distance(const Eigen::Vector2d& point) const {
    double least = 1e9;
    for (const auto& wall : walls_) {
      const Eigen::Vector2d along = wall.to - wall.from;
      const double way = std::clamp((point - wall.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (wall.from + way * along - point).norm());
    }
    return least;
  }

 private:
  void addBox(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d corners[] = {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    for (int i = 0; i < 4; ++i) walls_.push_back({corners[i], corners[(i + 1) % 4]});
  }

  double rangeAt(const Pose2& T_map_sensor, double bearing) const {
    const Eigen::Vector2d from = T_map_sensor.position();
    const double angle = T_map_sensor.theta() + bearing;
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    double nearest = 1e9;
    for (const auto& wall : walls_) {
      const Eigen::Vector2d along = wall.to - wall.from, to = wall.from - from;
      const double det = ray.x() * along.y() - ray.y() * along.x();
      if (std::abs(det) < 1e-12) continue;
      const double range = (to.x() * along.y() - to.y() * along.x()) / det;
      const double way = (to.x() * ray.y() - to.y() * ray.x()) / det;
      if (range > 0 && way >= 0 && way <= 1) nearest = std::min(nearest, range);
    }
    return nearest;
  }

  std::vector<Wall> walls_;
};

}  // namespace slam::point_map::test
