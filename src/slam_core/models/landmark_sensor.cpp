// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_sensor.hpp"

#include <cmath>
#include <utility>

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
  const auto correction = [&](const std::string& name, double* value, const std::string& sentence,
                              const std::string& unit, const Range& range) {
    fields.add(name, value, sentence).unit(unit).in(range).ofRobot();
  };
  correction("range_scale", &range_scale, "true range over measured range, from a calibration", "1",
             Range::open(0, 10));
  correction("mount_x", &mount_x,
             "the sensor stands so much further ahead than its transform says, from a calibration",
             "m", Range::closed(-10, 10));
  correction("mount_y", &mount_y, "the same to the left", "m", Range::closed(-10, 10));
  correction("mount_yaw", &mount_yaw,
             "the sensor is turned counter-clockwise by so much more than its transform says, from "
             "a calibration",
             "rad", Range::closed(-3.15, 3.15));
  correction("time_offset", &time_offset,
             "observations were made so much later than their stamps say, from a calibration", "s",
             Range::closed(-1, 1));
}

CalibrationVector LandmarkSensorConfig::calibration() const {
  CalibrationVector parameters = CalibrationVector::Zero();
  parameters(kRangeScale) = std::log(range_scale);
  parameters(kSensorX) = mount_x;
  parameters(kSensorY) = mount_y;
  parameters(kSensorYaw) = mount_yaw;
  return parameters;
}

void completeCovariances(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array) {
  for (auto& observation : array.observations) {
    if (observation.hasCovariance()) continue;
    const double relative = sensor.sigma_range_relative * observation.range;
    observation.covariance << sensor.sigma_range * sensor.sigma_range + relative * relative, 0, 0,
        sensor.sigma_bearing * sensor.sigma_bearing;
  }
}

void correct(const LandmarkSensorConfig& sensor, LandmarkObservationArray& array) {
  const auto parameters = sensor.calibration();
  if (!parameters.isZero(0.0))
    array = calibrated(std::move(array), Eigen::Vector3d::Zero(), parameters);
  array.stamp = array.stamp + durationFromSeconds(sensor.time_offset);
}

}  // namespace slam
