// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/planar_camera.hpp"

namespace slam {

Eigen::Isometry3d PlanarCamera::pose(const Pose2& T_map_base) const {
  Eigen::Isometry3d T_map_base_3d = Eigen::Isometry3d::Identity();
  T_map_base_3d.linear().topLeftCorner<2, 2>() = T_map_base.rotation();
  T_map_base_3d.translation().head<2>() = T_map_base.position();
  return T_map_base_3d * T_base_camera_;
}

Eigen::Vector3d PlanarCamera::centre(const Pose2& T_map_base, Eigen::Matrix3d* J_pose) const {
  const Eigen::Vector3d in_base = T_base_camera_.translation();
  Eigen::Matrix<double, 2, 3> J_plane;
  const Eigen::Vector2d in_plane = T_map_base.transform(in_base.head<2>(), &J_plane);
  if (J_pose != nullptr) *J_pose << J_plane, Eigen::RowVector3d::Zero();
  return {in_plane.x(), in_plane.y(), in_base.z()};
}

std::optional<PlanarCamera::Projection> PlanarCamera::project(const Pose2& T_map_base,
                                                              const Eigen::Vector3d& vector) const {
  const Eigen::Matrix3d R_camera_map = pose(T_map_base).linear().transpose();
  Eigen::Matrix<double, 2, 3> J_camera;
  const auto pixel = model_->project(R_camera_map * vector, &J_camera);
  if (!pixel) return std::nullopt;
  Projection projection{*pixel, J_camera * R_camera_map, {}};
  // A turn of the robot turns the vector the other way round, as the robot sees it.
  projection.J_theta = projection.J_vector * Eigen::Vector3d(vector.y(), -vector.x(), 0.0);
  return projection;
}

std::optional<Eigen::Vector3d> PlanarCamera::ray(const Pose2& T_map_base,
                                                 const Eigen::Vector2d& pixel) const {
  const auto on_plane = model_->unproject(pixel);
  if (!on_plane) return std::nullopt;
  return pose(T_map_base).linear() * on_plane->homogeneous().normalized();
}

}  // namespace slam
