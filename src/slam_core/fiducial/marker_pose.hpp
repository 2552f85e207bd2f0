// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/fiducial/pose_refinement.hpp"

namespace slam::fiducial {

/// What four corners tell about a marker's pose.
struct MarkerPose {
  /// The two poses that explain the corners, the better one first. Where there is only one the
  /// second has an infinite error.
  std::array<RefinedPose, 2> solutions;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    ///< of the centre, in the camera [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the position [m^2]

  double reprojectionError() const;  ///< of the better pose, root mean square over corners [px]
  /// Between the marker's normal and the line of sight, 0: seen from the front [rad]. About the
  /// same for both poses.
  double obliqueness() const;
};

/// The position of a marker and its covariance, for corners with Gaussian noise of standard
/// deviation `corner_sigma` [px] in both directions.
///
/// Both solutions of the infinitesimal plane-based estimate are refined to maxima of the likelihood
/// and weighed by how much probability lies around each (Laplace's approximation), so that it does
/// not matter which of them is the true one. Each has its bias of second order taken out (Box
/// 1971): seen from the front a marker can only look tilted, never the opposite, and would come out
/// too near. Nothing when the corners fit no pose.
std::optional<MarkerPose> estimatePose(const CameraModel& camera, const Corners& corners,
                                       double size, double corner_sigma);

}  // namespace slam::fiducial
