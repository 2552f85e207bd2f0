// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// A camera on a robot that moves in the plane, in normalised image coordinates: points of the map
/// [m] to the plane z = 1 before the camera, whose lens is taken out (CameraModel::unproject);
/// PlanarCamera leads to pixels. Jacobians are by the coordinates (x, y, theta) of the robot's pose
/// and by the point.
class NormalisedCamera {
 public:
  NormalisedCamera() = default;
  explicit NormalisedCamera(const Eigen::Isometry3d& T_base_camera)
      : T_camera_base_(T_base_camera.inverse()) {}

  /// The point in the optical frame [m].
  Eigen::Vector3d inCamera(const Pose2& T_map_base, const Eigen::Vector3d& point) const;
  /// Where the camera sees a point; nothing behind it or nearer than 1 cm.
  std::optional<Eigen::Vector2d> project(const Pose2& T_map_base, const Eigen::Vector3d& point,
                                         Eigen::Matrix<double, 2, 3>* J_pose = nullptr,
                                         Eigen::Matrix<double, 2, 3>* J_point = nullptr) const;
  /// The direction in the map frame in which the camera sees a point of the plane z = 1; its length
  /// is that of (x, y, 1).
  Eigen::Vector3d ray(const Pose2& T_map_base, const Eigen::Vector2d& on_plane) const;
  /// The camera's centre in the map frame [m].
  Eigen::Vector3d centre(const Pose2& T_map_base) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(T_camera_base_.matrix());
  }

 private:
  Eigen::Isometry3d T_camera_base_ = Eigen::Isometry3d::Identity();
};

}  // namespace slam
