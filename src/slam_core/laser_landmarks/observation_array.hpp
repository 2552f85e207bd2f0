// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// What a scan shows before anything is found in it.
inline LandmarkObservationArray emptyArray(const LaserScan& scan, std::uint64_t sequence) {
  LandmarkObservationArray array;
  array.sequence = sequence;
  array.stamp = scan.stamp;
  array.sensor_frame = scan.sensor_frame;
  array.sensor_pose = scan.sensor_pose;
  return array;
}

/// A point landmark without an id, by its place in the sensor's frame and the covariance of that
/// [m, m^2].
inline LandmarkObservation observationOf(const Eigen::Vector2d& place,
                                         const Eigen::Matrix2d& covariance) {
  const double range = place.norm();
  Eigen::Matrix2d J;
  J << place.x() / range, place.y() / range, -place.y() / (range * range),
      place.x() / (range * range);
  return {kUnknownId, range, std::atan2(place.y(), place.x()), J * covariance * J.transpose()};
}

}  // namespace slam::laser_landmarks
