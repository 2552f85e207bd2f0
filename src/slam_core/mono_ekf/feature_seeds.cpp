// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/feature_seeds.hpp"

#include <Eigen/LU>
#include <cmath>

#include "slam_core/mono_ekf/inverse_depth.hpp"
#include "slam_core/mono_ekf/patch.hpp"

namespace slam::mono_ekf {

std::optional<MonoState::Seed> raySeed(const Eigen::Vector2d& pixel, const PlanarCamera& camera,
                                       const Pose2& T_map_base, double rho) {
  const auto ray = camera.ray(T_map_base, pixel);
  if (!ray) return std::nullopt;
  const auto projection = camera.project(T_map_base, *ray);
  if (!projection) return std::nullopt;
  MonoState::Seed seed;
  auto& first = seed.feature.first;
  Eigen::Matrix3d J_centre_pose;
  first.centre = camera.centre(T_map_base, &J_centre_pose);
  first.ray = *ray;
  const double azimuth = std::atan2(ray->y(), ray->x()), elevation = std::asin(ray->z());
  seed.coordinates << first.centre.head<2>(), azimuth, elevation, rho;

  Eigen::Matrix<double, 3, 2> J_ray;
  directionOf(azimuth, elevation, &J_ray);
  const Eigen::Matrix2d J_pixel_angles = projection->J_vector * J_ray;
  seed.J_pixel.setZero();
  seed.J_pixel.middleRows<2>(2) = J_pixel_angles.inverse();
  seed.J_pose.setZero();
  seed.J_pose.topRows<2>() = J_centre_pose.topRows<2>();
  seed.J_pose(2, 2) = 1.0;  // the ray turns with the robot

  first.tangents << J_ray.col(0).normalized(), J_ray.col(1).normalized();
  first.J_pixel_tangents = projection->J_vector * first.tangents;
  return seed.J_pixel.allFinite() ? std::optional(seed) : std::nullopt;
}

std::optional<MonoState::Seed> seedAt(const Eigen::Vector2d& pixel, const cv::Mat& gray,
                                      const PlanarCamera& camera, const Pose2& T_map_base,
                                      double rho) {
  auto seed = raySeed(pixel, camera, T_map_base, rho);
  if (!seed) return std::nullopt;
  auto& first = seed->feature.first;
  first.patch = Patch::cut(gray, pixel);
  const bool is_corner = !first.patch.empty() && Patch::seen(first, first.J_pixel_tangents, 1.0);
  return is_corner ? seed : std::nullopt;
}

}  // namespace slam::mono_ekf
