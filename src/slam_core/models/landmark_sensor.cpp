// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_sensor.hpp"

namespace slam {

void LandmarkSensorConfig::describe(Fields& fields) {
  fields.add("sigma_range", &sigma_range, "standard deviation of a range")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("sigma_range_relative", &sigma_range_relative,
           "further standard deviation of a range, as a share of it")
      .unit("1")
      .in(Range::closed(0, 1))
      .ofRobot();
  fields.add("sigma_bearing", &sigma_bearing, "standard deviation of a bearing")
      .unit("rad")
      .in(Range::above(0))
      .ofRobot();
}

void completeCovariances(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array) {
  for (auto& observation : array.observations) {
    if (observation.hasCovariance()) continue;
    const double relative = sensor.sigma_range_relative * observation.range;
    observation.covariance << sensor.sigma_range * sensor.sigma_range + relative * relative, 0, 0,
        sensor.sigma_bearing * sensor.sigma_bearing;
  }
}

}  // namespace slam
