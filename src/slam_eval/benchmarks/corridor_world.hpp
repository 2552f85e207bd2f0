// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::eval {

/// An endless corridor along x, 3 m wide, with niches of different depths on both sides: a map of
/// any size for a laser, of which each place tells where it is.
class Corridor {
 public:
  static constexpr double kReach = 8.0;  ///< of the laser [m]

  /// Where a ray meets the walls [m]; kReach where it meets none before.
  double range(const Eigen::Vector2d& from, double direction) const;

 private:
  using Segment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;
  static std::vector<Segment> near(double x);
};

/// A robot that drives along it and looks ahead over 180 degrees. Its motion has the noise that it
/// claims, and its ranges 1 cm.
class CorridorDrive {
 public:
  struct Step {
    Motion motion;
    LaserScan scan;
    Pose2 truth;  ///< in the frame of the first pose, which is in the middle, along the corridor
  };

  /// @param beams of a scan
  explicit CorridorDrive(int beams) : beams_(beams) {}

  /// The next step of so much way [m], back where it is negative.
  Step step(double way);
  /// Goes to another place without being seen.
  void jumpTo(double x) { truth_ = Pose2(x, 0.0, 0.0); }

 private:
  LaserScan look(Stamp stamp);
  Stamp stamp() const { return stampFromNanoseconds(1'000'000'000'000 + 100'000'000 * count_); }

  Corridor corridor_;
  int beams_;
  Pose2 truth_, odometry_;
  std::int64_t count_ = 0;
  RandomStream random_{1, 0};
};

}  // namespace slam::eval
