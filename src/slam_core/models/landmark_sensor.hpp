// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// The robot file's noise of its landmark sensor, for observations that bring no covariance.
struct LandmarkSensorConfig {
  static constexpr const char* kSection = "landmark_sensor";

  double sigma_range = 0.1;
  double sigma_range_relative = 0.0;
  double sigma_bearing = 0.05;

  void describe(Fields& fields);
};

/// Fills in the covariance of those observations that came without one: the range has the variance
/// sigma_range^2 + (sigma_range_relative r)^2.
void completeCovariances(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array);

}  // namespace slam
