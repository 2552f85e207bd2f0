// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu/imu_config.hpp"

#include "slam_core/geometry/mount.hpp"

namespace slam {

void ImuConfig::describe(Fields& fields) {
  fields
      .add("sensor_pose", &sensor_pose,
           "[x, y, z, roll, pitch, yaw] of the IMU's frame in the base frame, instead of the "
           "transform that the robot publishes; only the rotation counts")
      .unit("m, rad")
      .ofRobot();
  fields
      .add("units", &units, {{"rad", Units::kRadians}, {"deg", Units::kDegrees}},
           "in which the driver gives angular velocities per second; ROS has them in rad")
      .ofRobot();
  fields
      .add("gyro_noise", &gyro_noise,
           "the gyro's noise density, which counts until the noise has been measured at rest: the "
           "standard deviation of the heading after one second")
      .unit("rad/sqrt(s)")
      .in(Range::closed(1e-7, 1))
      .ofRobot();
  fields
      .add("bias_sigma", &bias_sigma,
           "standard deviation of what the gyro measures at rest, before anything is known of it")
      .unit("rad/s")
      .in(Range::closed(1e-7, 1))
      .ofRobot();
  fields
      .add("bias_random_walk", &bias_random_walk,
           "standard deviation by which that has changed after one second")
      .unit("rad/s/sqrt(s)")
      .in(Range::closed(1e-9, 0.1))
      .ofRobot();
  fields
      .add(
          "scale_sigma", &scale_sigma,
          "standard deviation of the share by which the gyro measures turns too large or too small")
      .unit("1")
      .in(Range::closed(0, 0.5))
      .ofRobot();
}

std::optional<Eigen::Isometry3d> ImuConfig::mount() const {
  return mountOf(sensor_pose, std::string(kSection) + ".sensor_pose");
}

}  // namespace slam
