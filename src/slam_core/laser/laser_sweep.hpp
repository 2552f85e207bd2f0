// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam {

/// One sweep as a laser's driver tells it, not checked (sensor_msgs/LaserScan; ranges as of
/// REP-117). Clockwise where angle_increment is below 0.
struct LaserSweep {
  Stamp stamp;
  std::string frame;
  float angle_min = 0.0f, angle_max = 0.0f, angle_increment = 0.0f;  ///< about the frame's z [rad]
  float range_min = 0.0f, range_max = 0.0f;                          ///< [m]
  std::vector<float> ranges;                                         ///< [m]
  std::vector<float> intensities;  ///< one for each range, in the sensor's own unit; or none

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, frame, angle_min, angle_max, angle_increment, range_min, range_max, ranges,
            intensities);
  }
};

/// Where a laser is mounted: its frame (x ahead, y left, beams in the plane of both) in the robot's
/// base frame.
struct LaserMount {
  std::string frame;  ///< the laser's
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(frame, T_base_laser.matrix());
  }
};

/// Empty, or what makes the sweep unusable: angles or limits that are none, an increment that leads
/// away from angle_max, another number of ranges than the angles tell.
std::string faultOf(const LaserSweep& sweep);

/// Empty, or what makes the mount unusable: no rotation, or a scan plane that is not horizontal
/// within kMaxTilt.
std::string faultOf(const LaserMount& mount);

/// [rad]. At 10 m such a beam is 1 m higher or lower.
constexpr double kMaxTilt = 0.1;

/// The sweep as seen from above: an upside-down laser's bearings are mirrored. Ranges that are not
/// a number, -Inf, 0 or below range_min tell nothing and are left out; +Inf and those beyond
/// range_max met nothing up to there. Intensities of another number than the ranges are not used.
/// @param sweep, mount without faults
LaserScan toScan(const LaserSweep& sweep, const LaserMount& mount);

}  // namespace slam
