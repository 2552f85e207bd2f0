// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/covariance.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::test {

/// Walls that beams meet.
class Room {
 public:
  /// Ten metres by eight with a niche, a box in the middle and a pillar: no two places look alike.
  Room() {
    addLoop({{-5, -4}, {5, -4}, {5, 2}, {3.5, 2}, {3.5, 4}, {-5, 4}});
    addLoop({{-0.6, -0.5}, {0.8, -0.5}, {0.8, 0.7}, {-0.6, 0.7}});
    addLoop({{-3.9, 2.6}, {-3.5, 2.6}, {-3.5, 3.0}, {-3.9, 3.0}});
  }

  /// A rectangle around the origin. @param length, width along x and y [m]
  Room(double length, double width) {
    const double x = 0.5 * length, y = 0.5 * width;
    addLoop({{-x, -y}, {x, -y}, {x, y}, {-x, y}});
  }

  /// To the nearest wall [m].
  double distance(const Eigen::Vector2d& point) const {
    double least = INFINITY;
    for (const auto& [a, b] : walls_) {
      const double along = (point - a).dot(b - a) / (b - a).squaredNorm();
      const Eigen::Vector2d foot = a + std::clamp(along, 0.0, 1.0) * (b - a);
      least = std::min(least, (point - foot).norm());
    }
    return least;
  }

  /// To the first wall in a direction [m]; infinite where there is none.
  double range(const Eigen::Vector2d& from, double direction) const {
    const Eigen::Vector2d ray(std::cos(direction), std::sin(direction));
    double nearest = INFINITY;
    for (const auto& [a, b] : walls_) {
      const Eigen::Vector2d wall = b - a, to_wall = a - from;
      const double sine = cross(ray, wall);  // times the wall's length; 0 if they are parallel
      const double along_ray = cross(to_wall, wall) / sine, along_wall = cross(to_wall, ray) / sine;
      const bool is_met = sine != 0.0 && along_ray > 0.0 && along_wall >= 0.0 && along_wall <= 1.0;
      if (is_met) nearest = std::min(nearest, along_ray);
    }
    return nearest;
  }

 private:
  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  }
  void addLoop(const std::vector<Eigen::Vector2d>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      walls_.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> walls_;
};

/// A laser that looks ahead over 180 degrees.
inline LaserScan scanOf(const Room& room, const Pose2& base, const Pose2& sensor, int beams,
                        double sigma, RandomStream& random) {
  constexpr double kMostRange = 8.0;
  const Pose2 laser = base * sensor;
  LaserScan scan;
  scan.sensor_frame = "laser";
  scan.sensor_pose = sensor;
  for (int i = 0; i < beams; ++i) {
    const double bearing = M_PI * (static_cast<double>(i) / (beams - 1) - 0.5);
    const double range =
        room.range(laser.position(), laser.theta() + bearing) + sigma * random.gaussian();
    const bool hit = range < kMostRange;
    scan.beams.push_back(
        {static_cast<float>(bearing), static_cast<float>(hit ? range : kMostRange), hit});
  }
  return scan;
}

/// A robot that drives round the box in the room; its motion has exactly the noise it claims.
class RoomDrive {
 public:
  static constexpr int kLap = 145;  ///< steps of once round the box

  struct Step {
    Motion motion;
    LaserScan scan;
    Pose2 truth;  ///< in the frame of the first pose
  };

  explicit RoomDrive(std::uint64_t seed) : random_(seed, 0) {
    Q_ << 1e-4, 0, 0, 0, 2e-5, 1e-5, 0, 1e-5, 2e-4;
  }

  /// The first scan is taken before the robot moves: it defines the map's frame.
  Step next() {
    const bool stands = count_ == 0;
    const Pose2 way = stands ? Pose2() : Pose2::exp({way_of_step, 0.0, way_of_step / kRadius});
    const Eigen::Matrix3d Q = stands ? Eigen::Matrix3d(1e-10 * Q_) : Q_;
    Step step;
    step.motion.sequence = count_;
    step.motion.start = stamp();
    ++count_;
    step.motion.end = step.scan.stamp = stamp();
    step.motion.covariance = Q;
    step.motion.odometry_frame = "odom";
    step.motion.base_frame = "base_link";
    const Eigen::Vector3d white(random_.gaussian(), random_.gaussian(), random_.gaussian());
    step.motion.increment = Pose2::fromVector(way.vector() + withCovariance(Q, white));
    step.motion.odometry_start = odometry_;
    step.motion.odometry_end = odometry_ = odometry_ * step.motion.increment;
    truth_ = truth_ * way;  // stays on its circle: it is the odometry that errs
    step.scan = scanOf(room_, truth_, sensorPose(), beams, 0.01, random_);
    step.scan.stamp = stamp();
    step.truth = start().between(truth_);
    return step;
  }

  const Room& room() const { return room_; }
  /// The laser in the robot's frame.
  static Pose2 sensorPose() { return {0.1, 0.0, 0.05}; }
  /// In the room's frame.
  static Pose2 start() { return {0.1, -2.2, 0.0}; }
  /// What the robot has seen, from its first pose, with the noise of a camera.
  LandmarkObservation sight(LandmarkId id, const Eigen::Vector2d& landmark) {
    LandmarkObservation z;
    const Eigen::Vector2d seen = start().between(truth_).inverse().transform(landmark);
    z.id = id;
    z.range = seen.norm() + 0.02 * random_.gaussian();
    z.bearing = std::atan2(seen.y(), seen.x()) + 0.01 * random_.gaussian();
    z.covariance << 4e-4, 0, 0, 1e-4;
    return z;
  }

  int beams = 181;
  double way_of_step = 0.1;  ///< [m]
  Duration interval = std::chrono::milliseconds(100);

 private:
  static constexpr double kRadius = 2.3;
  Stamp stamp() const {
    return stampFromNanoseconds(1000000000000) + static_cast<std::int64_t>(count_) * interval;
  }

  RandomStream random_;
  Room room_;
  Eigen::Matrix3d Q_;
  Pose2 truth_ = start(), odometry_;
  std::uint64_t count_ = 0;
};

/// Share of the occupied cells of a map of such a drive that lie on the room's walls, give or take
/// a cell.
inline double shareOnWalls(const OccupancyGrid& grid, const Room& room) {
  int occupied = 0, right = 0;
  for (std::uint32_t y = 0; y < grid.height; ++y)
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      if (grid.cells[y * grid.width + x] <= 50) continue;
      ++occupied;
      const Eigen::Vector2d middle =
          grid.origin + grid.resolution * Eigen::Vector2d(x + 0.5, y + 0.5);
      right += room.distance(RoomDrive::start().transform(middle)) < 0.075;
    }
  return occupied < 500 ? 0.0 : static_cast<double>(right) / occupied;
}

}  // namespace slam::test
