// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/descriptor.hpp"

namespace slam {

using LandmarkId = std::int64_t;
constexpr LandmarkId kUnknownId = -1;

/// What a landmark is: a point, or the straight face of a wall.
enum class LandmarkKind : std::uint8_t { kPoint = 0, kLine = 1 };

/// The part of a line that was seen [m], along it from a point of it: to the left of whoever looks
/// at it is positive.
struct LineExtent {
  double begin = 0.0, end = 0.0;

  template <class Archive>
  void persist(Archive& archive) {
    archive(begin, end);
  }
};

/// Range [m] and bearing [rad] of a landmark in the sensor's horizontal plane, Eq. 5.3. Those of a
/// line are the length and the direction of the perpendicular from the sensor to it.
struct LandmarkObservation {
  LandmarkId id = kUnknownId;
  double range = 0.0;
  double bearing = 0.0;
  /// of (range, bearing) [m^2, m rad, rad^2]; element (0, 0) = -1 stands for "unknown"
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  LandmarkKind kind = LandmarkKind::kPoint;
  LineExtent extent = {};      ///< of a line, from the foot of the perpendicular
  Descriptor descriptor = {};  ///< empty where the detector gives none

  Eigen::Vector2d vector() const { return {range, bearing}; }
  bool hasCovariance() const { return covariance(0, 0) != -1.0; }
  bool isLine() const { return kind == LandmarkKind::kLine; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(id, range, bearing, covariance, kind, extent, descriptor);
  }
};

/// What one sensor saw at one instant; empty when it saw nothing.
struct LandmarkObservationArray {
  std::uint64_t sequence = 0;
  Stamp stamp;
  std::string sensor_frame;
  Pose2 sensor_pose;  ///< T_base_sensor
  std::vector<LandmarkObservation> observations;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sequence, stamp, sensor_frame, sensor_pose, observations);
  }
};

/// Empty, or what makes the observation unusable (NaN, a range that is not positive or absurd, a
/// covariance that is not positive definite, absurdly large or absurdly small, a line without a
/// length). Of the descriptor faultOf(Descriptor) says the same.
std::string faultOf(const LandmarkObservation& observation);

}  // namespace slam
