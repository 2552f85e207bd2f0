// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::fiducial {

/// Range, bearing and their covariance of a point in the robot's horizontal plane, seen from a
/// camera: from the camera's horizontal position, bearing 0 along the robot's x axis. `position`
/// [m] and `covariance` [m^2] are in the camera's frame. Nothing where the point is so close above
/// or below the camera that its horizontal position is uncertain by more than `max_relative_sigma`
/// of its range: range and bearing would be neither Gaussian nor unbiased.
std::optional<LandmarkObservation> rangeAndBearing(const Eigen::Vector3d& position,
                                                   const Eigen::Matrix3d& covariance,
                                                   const Eigen::Matrix3d& R_base_camera,
                                                   double max_relative_sigma);

}  // namespace slam::fiducial
