// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <string>

#include "slam_core/common/time.hpp"
#include "slam_core/models/imu_sample.hpp"

namespace slam {

/// One message of an IMU's driver, not checked (sensor_msgs/Imu). Accelerations and orientation are
/// not used. Of a driver that counts in degrees it holds degrees until fromDegrees().
struct ImuReading {
  Stamp stamp;
  std::string frame;
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< about the frame's axes [rad/s]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();        ///< of it [rad^2/s^2]

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, frame, angular_velocity, covariance);
  }
};

/// Where an IMU is mounted: its frame in the robot's base frame.
struct ImuMount {
  std::string frame;  ///< the IMU's
  Eigen::Isometry3d T_base_imu = Eigen::Isometry3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(frame, T_base_imu.matrix());
  }
};

/// Empty, or what makes the reading unusable: NaN, a rate that no robot turns at.
std::string faultOf(const ImuReading& reading);

/// Empty, or what makes the mount unusable: no rotation.
std::string faultOf(const ImuMount& mount);

/// Whether the reading says that its IMU has no gyro: by sensor_msgs/Imu, -1 as the first element
/// of the covariance. Drivers of gyros set that as well where they know no covariance; so only a
/// reading whose rates are all exactly zero says it.
bool saysNoGyro(const ImuReading& reading);

/// The same reading in radians, of a driver that counts in degrees.
ImuReading fromDegrees(const ImuReading& reading);

/// The reading seen from the base. A covariance that is none is left out: drivers that give none
/// fill in zeros, or -1 first.
/// @param reading, mount without faults
ImuSample toSample(const ImuReading& reading, const ImuMount& mount);

}  // namespace slam
