// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/normalised_camera.hpp"

namespace slam {
namespace {

constexpr double kNearest = 0.01;  // [m]

/// The point in the robot's base frame.
Eigen::Vector3d inBase(const Pose2& T_map_base, const Eigen::Vector3d& point) {
  const Eigen::Vector2d moved =
      T_map_base.rotation().transpose() * (point.head<2>() - T_map_base.position());
  return {moved.x(), moved.y(), point.z()};
}

}  // namespace

Eigen::Vector3d NormalisedCamera::inCamera(const Pose2& T_map_base,
                                           const Eigen::Vector3d& point) const {
  return T_camera_base_ * inBase(T_map_base, point);
}

std::optional<Eigen::Vector2d> NormalisedCamera::project(
    const Pose2& T_map_base, const Eigen::Vector3d& point, Eigen::Matrix<double, 2, 3>* J_pose,
    Eigen::Matrix<double, 2, 3>* J_point) const {
  const Eigen::Vector3d in_base = inBase(T_map_base, point);
  const Eigen::Vector3d p = T_camera_base_ * in_base;
  if (!(p.z() > kNearest)) return std::nullopt;
  const Eigen::Vector2d seen = p.head<2>() / p.z();
  if (J_pose == nullptr && J_point == nullptr) return seen;
  Eigen::Matrix<double, 2, 3> J_camera;
  J_camera << 1.0, 0.0, -seen.x(), 0.0, 1.0, -seen.y();
  const Eigen::Matrix<double, 2, 3> J_base = J_camera / p.z() * T_camera_base_.linear();
  const Eigen::Matrix2d R_transposed = T_map_base.rotation().transpose();
  if (J_pose != nullptr) {
    J_pose->leftCols<2>() = -J_base.leftCols<2>() * R_transposed;
    J_pose->col(2) = J_base.leftCols<2>() * Eigen::Vector2d(in_base.y(), -in_base.x());
  }
  if (J_point != nullptr) {
    J_point->leftCols<2>() = J_base.leftCols<2>() * R_transposed;
    J_point->col(2) = J_base.col(2);
  }
  return seen;
}

Eigen::Vector3d NormalisedCamera::ray(const Pose2& T_map_base,
                                      const Eigen::Vector2d& on_plane) const {
  const Eigen::Vector3d in_base = T_camera_base_.linear().transpose() * on_plane.homogeneous();
  const Eigen::Vector2d turned = T_map_base.rotation() * in_base.head<2>();
  return {turned.x(), turned.y(), in_base.z()};
}

Eigen::Vector3d NormalisedCamera::centre(const Pose2& T_map_base) const {
  const Eigen::Vector3d in_base = T_camera_base_.inverse().translation();
  const Eigen::Vector2d moved = T_map_base.transform(in_base.head<2>());
  return {moved.x(), moved.y(), in_base.z()};
}

}  // namespace slam
