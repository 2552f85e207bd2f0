// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "slam_core/camera/camera_model.hpp"

namespace slam {

/// The ceiling as an upward-looking camera sees it: a horizontal plane at a known height above the
/// camera. Its points are given by x and y of the robot's base frame [m], so that the motion of the
/// points between two images is that of the robot, wherever the camera is mounted and however it is
/// turned; a tilt that the mount tells is undone as well.
class CeilingView {
 public:
  CeilingView() = default;
  /// @param height of the ceiling above the camera's centre, above 0 [m]
  CeilingView(const CameraModel& camera, const Eigen::Isometry3d& T_base_camera, double height);

  /// The point that a pixel sees; nothing where it looks too flat or the lens sees nothing.
  std::optional<Eigen::Vector2d> toCeiling(const Eigen::Vector2d& pixel) const;
  /// The pixel that sees a point; it may lie outside the image.
  std::optional<Eigen::Vector2d> toPixel(const Eigen::Vector2d& point) const;

  /// The point right above the camera, which is the sensor's place in the robot's plane as well
  /// [m].
  Eigen::Vector2d origin() const { return T_base_camera_.translation().head<2>(); }
  /// The height of the ceiling above the camera's centre [m].
  double height() const { return height_; }
  /// Size of a pixel on the ceiling, right above the camera [m/px].
  double metresPerPixel() const { return metres_per_pixel_; }
  /// Angle between the camera's axis and straight up [rad].
  double tilt() const { return tilt_; }

 private:
  CameraModel camera_;
  Eigen::Isometry3d T_base_camera_ = Eigen::Isometry3d::Identity();
  double height_ = 0.0, metres_per_pixel_ = 0.0, tilt_ = 0.0;
};

}  // namespace slam
