// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/ceiling_view.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

constexpr double kMinElevation = 0.2;  // sine of the angle above the horizon

}  // namespace

CeilingView::CeilingView(const CameraModel& camera, const Eigen::Isometry3d& T_base_camera,
                         double height)
    : camera_(camera), T_base_camera_(T_base_camera), height_(height) {
  const auto& calibration = camera.calibration();
  metres_per_pixel_ = height / std::sqrt(calibration.fx * calibration.fy);
  tilt_ = std::acos(std::clamp(T_base_camera.linear()(2, 2), -1.0, 1.0));
}

std::optional<Eigen::Vector2d> CeilingView::toCeiling(const Eigen::Vector2d& pixel) const {
  const auto on_plane = camera_.unproject(pixel);
  if (!on_plane) return std::nullopt;
  const Eigen::Vector3d ray = T_base_camera_.linear() * on_plane->homogeneous();
  if (!(ray.z() > kMinElevation * ray.norm())) return std::nullopt;
  return Eigen::Vector2d(T_base_camera_.translation().head<2>() +
                         height_ / ray.z() * ray.head<2>());
}

std::optional<Eigen::Vector2d> CeilingView::toPixel(const Eigen::Vector2d& point) const {
  Eigen::Vector3d ray;
  ray << point - T_base_camera_.translation().head<2>(), height_;
  return camera_.project(T_base_camera_.linear().transpose() * ray);
}

}  // namespace slam
