// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// One beam of a laser in the horizontal plane.
struct LaserBeam {
  float bearing = 0.0f;    ///< about +z from the sensor's x axis [rad]
  float range = 0.0f;      ///< up to what it met, or up to where it met nothing [m]
  bool hit = false;        ///< it met something
  float intensity = 0.0f;  ///< of what came back, in the sensor's own unit; 0 where it tells none

  /// Its end in the sensor frame [m].
  Eigen::Vector2d end() const {
    return {range * std::cos(static_cast<double>(bearing)),
            range * std::sin(static_cast<double>(bearing))};
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(bearing, range, hit, intensity);
  }
};

/// The beams of one laser, which have one origin.
struct LaserFan {
  Pose2 sensor_pose;            ///< T_base_sensor
  double relative_sigma = 0.0;  ///< standard deviation of a range, relative to it
  std::vector<LaserBeam> beams;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sensor_pose, relative_sigma, beams);
  }
};

/// One sweep of a laser, whatever its mount, seen as horizontal. Beams that tell nothing (not a
/// number, nearer than the sensor can measure) are not among them; the others keep the sweep's
/// order. A joined scan holds what further lasers saw as well.
struct LaserScan : LaserFan {
  std::uint64_t sequence = 0;
  Stamp stamp;
  std::string sensor_frame;
  /// These beams are those of further lasers. Their poses are those in the base frame at `stamp`,
  /// also where the robot has moved between the stamps.
  std::vector<LaserFan> further;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sequence, stamp, sensor_frame, sensor_pose, relative_sigma, beams, further);
  }
};

/// Calls visit(fan) for each laser's part of a scan, the scan's own first.
template <class Visit>
void forEachFan(const LaserScan& scan, const Visit& visit) {
  visit(static_cast<const LaserFan&>(scan));
  for (const auto& fan : scan.further) visit(fan);
}

}  // namespace slam
