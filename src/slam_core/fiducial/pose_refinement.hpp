// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/fiducial/square_pose.hpp"

namespace slam::fiducial {

/// The corners of a square in the image, and the same corners in its own frame [m]. Refers to the
/// camera and the corners.
struct SquareView {
  const CameraModel& camera;
  const Corners& corners;
  std::array<Eigen::Vector3d, 4> square;
};

/// A marker's pose and the part of its corners that it does not explain.
struct RefinedPose {
  Eigen::Isometry3d T_camera_marker = Eigen::Isometry3d::Identity();
  double squared_error = 0.0;  ///< sum over the corners [px^2]
  /// J^T J of the corners in (position [m], rotation about the camera's axes [rad]): the inverse of
  /// the covariance for corners with a standard deviation of 1 px
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
};

/// A pose after a small step in (position, rotation about the camera's axes).
Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Eigen::Matrix<double, 6, 1>& step);

/// The error of the projected corners at a pose, 8x1 [px], and its 8x6 Jacobian in (position,
/// rotation about the camera's axes); nothing when a corner cannot be projected.
std::optional<Eigen::Matrix<double, 8, 1>> reprojectionError(
    const SquareView& view, const Eigen::Isometry3d& T_camera_marker,
    Eigen::Matrix<double, 8, 6>* J = nullptr);

/// The local minimum of the squared reprojection error near a pose (Levenberg-Marquardt): for
/// Gaussian noise of the corners the maximum-likelihood estimate. Nothing when the pose cannot be
/// projected.
std::optional<RefinedPose> refinePose(const SquareView& view,
                                      const Eigen::Isometry3d& T_camera_marker);

}  // namespace slam::fiducial
