// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace slam::eval {

/// A landmark in the horizontal plane through the sensor.
struct HorizontalReading {
  double range;                // horizontal distance [m]
  double bearing;              // about the vertical axis, from the sensor's heading [rad]
  Eigen::Matrix2d covariance;  // of (range, bearing)
};

/// Projects a reading of a sensor in space into the horizontal plane.
///
/// @param level_sensor rotation of the sensor without its yaw (identity when it is level)
/// @param spherical range [m], yaw [rad], pitch [rad]; a positive pitch looks down, as in MRPT
/// @param covariance of spherical; propagated to first order
HorizontalReading toHorizontal(const Eigen::Matrix3d& level_sensor,
                               const Eigen::Vector3d& spherical, const Eigen::Matrix3d& covariance);

}  // namespace slam::eval
