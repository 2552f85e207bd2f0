// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/calibration_check.hpp"

#include <string>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/models/landmark_sensor.hpp"

namespace slam {
namespace {

/// The odometry source whose motion is that of wheels alone.
constexpr const char* kWheels = "wheel";

/// What is listed. Where the section has faults, who reads it says so.
CalibrationConfig listed(Settings settings) {
  CalibrationConfig config;
  try {
    settings.read(config);
  } catch (const ConfigError&) {
    config.estimate.clear();
  }
  return config;
}

/// A correction of the mount counts for all that is observed.
void requireOneMount(const ProductConfig& product, Settings settings) {
  LandmarkSensorConfig sensor;
  try {
    settings.read(sensor);
  } catch (const ConfigError&) {
    return;  // who reads it says so
  }
  if (product.second_camera &&
      (sensor.mount_x != 0 || sensor.mount_y != 0 || sensor.mount_yaw != 0))
    throw ConfigError(
        "landmark_sensor: mount_x, mount_y and mount_yaw correct the mount of one camera, and with "
        "second_camera there are two; set them to 0 and correct camera.sensor_pose or the camera's "
        "transform instead");
}

}  // namespace

void checkCalibration(const ProductConfig& product, const Capabilities& backend,
                      Settings& settings) {
  requireOneMount(product, settings);
  const auto config = listed(settings);
  if (!config.isOn()) return;
  if (backend.find<Calibrator>() == nullptr) {
    settings.read<CalibrationConfig>();  // so that nobody calls the section unknown
    throw ConfigError("calibration.estimate: backend=" + product.backend +
                      " does not calibrate, backend=ekf and backend=graph do; use one of them, or "
                      "leave the list empty");
  }
  if (product.second_camera)
    throw ConfigError(
        "calibration.estimate: the calibration knows one landmark sensor, and with second_camera "
        "there are two; calibrate in a product with one camera, or leave the list "
        "empty");
  if (product.odometry == kWheels || product.odometry == "none") return;
  for (const auto& name : config.namesOfWheels())
    throw ConfigError("calibration.estimate: with odometry=" + product.odometry +
                      " wheels do not tell the motion, so that " + name +
                      " cannot be estimated; use odometry=wheel, or leave it out of the list");
}

}  // namespace slam
