// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_imu_odometry.hpp"

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::visual_odometry {
namespace {

const Registrar<OdometrySource, VisualImuOdometry> kImuRegistrar("visual_imu");

}  // namespace

void VisualImuOdometry::describe(Ports& ports) {
  ports.takes<CameraView>(CeilingCameraConfig::kSection, "images of the ceiling", this);
  ports.takes<ImuSample>("imu", "an IMU's angular velocities", this);
  ports.makes<Motion>("motion", motion());
}

}  // namespace slam::visual_odometry
