// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_core/models/calibration.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// What the robot file says of its landmark sensor: the noise of observations that bring no
/// covariance, and how what all observations say is to be corrected, as a calibration found it.
struct LandmarkSensorConfig {
  static constexpr const char* kSection = "landmark_sensor";

  double sigma_range = 0.1;
  double sigma_range_relative = 0.0;
  double sigma_bearing = 0.05;
  double range_scale = 1.0;
  double mount_x = 0.0, mount_y = 0.0, mount_yaw = 0.0;
  double time_offset = 0.0;

  void describe(Fields& fields);
  /// The corrections as parameters, without the time's.
  CalibrationVector calibration() const;
};

/// Fills in the covariance of those observations that came without one: the range has the variance
/// sigma_range^2 + (sigma_range_relative r)^2.
void completeCovariances(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array);

/// Corrects stamp, sensor pose and ranges.
void correct(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array);

}  // namespace slam
