// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser/laser_config.hpp"

#include "slam_core/geometry/mount.hpp"

namespace slam {

void LaserConfig::describe(Fields& fields) {
  fields
      .add("sensor_pose", &sensor_pose,
           "[x, y, z, roll, pitch, yaw] of the laser's frame in the base frame, instead of the "
           "transform that the robot publishes")
      .unit("m, rad")
      .ofRobot();
  fields
      .add("range_max", &range_max,
           "a beam that goes farther counts as one that met nothing up to here; 0: the range that "
           "the scans name")
      .unit("m")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("relative_sigma", &relative_sigma,
           "standard deviation of a range, relative to it: far ends count less in a grid map")
      .unit("1")
      .in(Range::closed(0, 0.5))
      .ofRobot();
}

std::optional<Eigen::Isometry3d> LaserConfig::mount(const std::string& section) const {
  return mountOf(sensor_pose, section + ".sensor_pose");
}

}  // namespace slam
