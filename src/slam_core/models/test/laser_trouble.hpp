// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "slam_core/models/test/simulated_room.hpp"

namespace slam::test {

/// A robot that drives along walls without ends, parallel to its way, which look the same
/// everywhere.
class EndlessDrive {
 public:
  /// @param walls how far to the left of the way [m]
  explicit EndlessDrive(std::vector<double> walls) : walls_(std::move(walls)) {
    drive_.beams = 721;
  }

  RoomDrive::Step next() {
    auto step = drive_.next();
    const bool stands = step.motion.sequence == 0;
    const auto steps = static_cast<double>(step.motion.sequence);
    const Pose2 way(std::min(0.1, 0.01 * steps), 0.0, 0.0);  // speeds up at 1 m/s^2
    const Pose2 noise = way_.between(step.motion.increment);
    step.motion.increment = stands ? step.motion.increment : way * noise;
    step.motion.odometry_start = odometry_;
    step.motion.odometry_end = odometry_ = odometry_ * step.motion.increment;
    step.truth = truth_ = truth_ * way;
    look(step.scan);
    return step;
  }

 private:
  void look(LaserScan& scan) {
    constexpr double kMostRange = 5.6, kSigma = 0.01;
    scan.sensor_pose = Pose2();
    for (auto& beam : scan.beams) {
      double range = INFINITY;
      for (const double wall : walls_) {
        const double to_wall = (wall - truth_.y()) / std::sin(truth_.theta() + beam.bearing);
        if (to_wall > 0.0) range = std::min(range, to_wall + kSigma * random_.gaussian());
      }
      beam.hit = range < kMostRange;
      beam.range = static_cast<float>(beam.hit ? range : kMostRange);
    }
  }

  std::vector<double> walls_;
  RoomDrive drive_{1};  ///< whose noise of the wheels it has
  RandomStream random_{2, 0};
  const Pose2 way_ = Pose2::exp({0.1, 0.0, 0.1 / 2.3});
  Pose2 truth_, odometry_;
};

/// Glass and people: a share of the beams ends anywhere before the wall.
inline void shorten(LaserScan& scan, double share, RandomStream& random) {
  for (auto& beam : scan.beams)
    if (random.uniform() < share) beam.range *= static_cast<float>(0.2 + 0.7 * random.uniform());
}

/// The laser is turned on its head, and nobody says so.
inline void mirror(LaserScan& scan) {
  for (auto& beam : scan.beams) beam.bearing = -beam.bearing;
}

}  // namespace slam::test
