// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_imu_odometry.hpp"

#include "slam_core/contract/registry.hpp"

namespace slam::laser_odometry {
namespace {

const Registrar<OdometrySource, LaserImuOdometry> kImuRegistrar("laser_imu");

}  // namespace

void LaserImuOdometry::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", this);
  ports.takes<ImuSample>("imu", "an IMU's angular velocities", this);
  ports.makes<Motion>("motion", motion());
}

}  // namespace slam::laser_odometry
