// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <utility>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// A calibrated camera on a robot that moves in the plane: what stands in the map frame (x, y in
/// the plane, z up) as pixels, and back. The robot's pose has three coordinates (x, y, theta);
/// height, tilt and roll of the camera are those of its mount.
class PlanarCamera {
 public:
  /// @param model of the camera, not null @param T_base_camera its optical frame in the base frame
  PlanarCamera(std::shared_ptr<const CameraModel> model, const Eigen::Isometry3d& T_base_camera)
      : model_(std::move(model)), T_base_camera_(T_base_camera) {}

  const CameraModel& model() const { return *model_; }
  /// The height of the camera's centre above the plane [m].
  double height() const { return T_base_camera_.translation().z(); }

  /// The camera's centre [m]; its Jacobian in the robot's pose (x, y, theta) has the row of z zero.
  Eigen::Vector3d centre(const Pose2& T_map_base, Eigen::Matrix3d* J_pose = nullptr) const;
  /// Where the optical frame is in the map frame.
  Eigen::Isometry3d pose(const Pose2& T_map_base) const;

  /// A pixel that sees something, with its Jacobians.
  struct Projection {
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> J_vector;  ///< [px/m]
    Eigen::Vector2d J_theta;               ///< in the robot's heading [px/rad]
  };
  /// The pixel that sees what lies in the direction of a vector from the camera's centre (map
  /// frame, whatever its length), which may lie outside the image; nothing where that is behind the
  /// camera or outside the lens's field of view.
  std::optional<Projection> project(const Pose2& T_map_base, const Eigen::Vector3d& vector) const;
  /// The direction in which a pixel looks, of length 1, map frame; nothing where it sees none.
  std::optional<Eigen::Vector3d> ray(const Pose2& T_map_base, const Eigen::Vector2d& pixel) const;

 private:
  std::shared_ptr<const CameraModel> model_;
  Eigen::Isometry3d T_base_camera_;
};

}  // namespace slam
