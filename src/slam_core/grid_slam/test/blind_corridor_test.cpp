// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/grid_slam/grid_slam.hpp"

// A laser alone that sees too short in a corridor: along it nothing tells how far the robot has
// gone, until the end of the corridor comes in sight.

namespace slam::grid_slam {
namespace {

constexpr double kBegin = -2.0, kEnd = 30.0, kHalfWidth = 1.2, kReach = 3.5;  // [m]

/// To the walls of the corridor, whose axis is x.
double rangeAt(double x, double bearing) {
  const double ahead = std::cos(bearing), aside = std::abs(std::sin(bearing));
  const double end = ahead > 0.0 ? kEnd - x : x - kBegin;
  return std::min(end / std::max(1e-9, std::abs(ahead)), kHalfWidth / std::max(1e-9, aside));
}

LaserScan scanAt(double x, Stamp stamp, RandomStream& random) {
  constexpr int kBeams = 720;
  LaserScan scan;
  scan.stamp = stamp;
  scan.sensor_frame = "laser";
  for (int i = 0; i < kBeams; ++i) {
    const double bearing = 2.0 * M_PI * i / kBeams - M_PI;
    const double range = rangeAt(x, bearing) + 0.01 * random.gaussian();
    const bool hit = range < kReach;
    scan.beams.push_back(
        {static_cast<float>(bearing), static_cast<float>(hit ? range : kReach), hit});
  }
  return scan;
}

/// The position's error of a robot that has come to the end of the corridor at 1 m/s.
struct Arrival {
  double error = 0.0;   ///< [m]
  double sigmas = 0.0;  ///< the same in reported standard deviations (Mahalanobis distance)
};

Arrival driveToTheEnd(std::uint64_t seed) {
  constexpr double kStop = 28.5, kStep = 0.1;  // [m]
  const auto backend = Registry<Backend>::instance().create("grid");
  Settings settings({}, {}, {"map=grid"});
  backend->configure(settings);
  Ports ports;
  backend->describe(ports);
  const auto& inputs = ports.inputs();
  const auto scans = std::find_if(inputs.begin(), inputs.end(),
                                  [](const auto& input) { return input.name == "scan"; });
  RandomStream random(seed, 0);
  double x = 0.0;
  for (int i = 0; i < 360; ++i) {
    constexpr int kStand = 20;  // steps before the drive
    x = std::min(kStop, kStep * std::max(0, i - kStand));
    const auto scan = scanAt(x, stampFromNanoseconds(1000000000 + i * 100000000LL), random);
    scans->set(&scan);
    backend->execute();
  }
  const auto estimate = backend->pose();
  const Eigen::Vector2d e = estimate.pose.position() - Eigen::Vector2d(x, 0.0);
  const Eigen::Matrix2d P = estimate.covariance.topLeftCorner<2, 2>();
  return {e.norm(), std::sqrt(e.dot(P.inverse() * e))};
}

TEST(BlindCorridor, ItsEndDoesNotTellHowLongItWas) {
  const GridSlam of_library;  // a library that no symbol is named of would not be linked
  for (const std::uint64_t seed : {1, 2}) {
    const auto arrival = driveToTheEnd(seed);
    EXPECT_LT(arrival.sigmas, 3.5) << "seed " << seed;
    EXPECT_GT(arrival.error, 1.0) << "else there is nothing to be unsure of";
  }
}

}  // namespace
}  // namespace slam::grid_slam
