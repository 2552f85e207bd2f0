// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_config.hpp"

#include "slam_core/geometry/mount.hpp"

namespace slam {

void CameraConfig::describe(Fields& fields) {
  fields
      .add("sensor_pose", &sensor_pose,
           "[x, y, z, roll, pitch, yaw] of the optical frame in the base frame, instead of the "
           "transform that the robot publishes")
      .unit("m, rad")
      .ofRobot();
}

std::optional<Eigen::Isometry3d> CameraConfig::mount(const std::string& section) const {
  return mountOf(sensor_pose, section + ".sensor_pose");
}

void CeilingCameraConfig::describe(Fields& fields) {
  CameraConfig::describe(fields);
  fields
      .add("ceiling_height", &ceiling_height,
           "of the ceiling above the camera, which gives all that is seen there its scale; 0: not "
           "known")
      .unit("m")
      .in(Range::atLeast(0))
      .ofRobot();
}

}  // namespace slam
