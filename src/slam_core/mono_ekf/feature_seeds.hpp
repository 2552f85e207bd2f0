// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "slam_core/mono_ekf/mono_state.hpp"

namespace slam::mono_ekf {

/// A feature that begins where a pixel looks, at inverse depth `rho` (Civera, Davison and Montiel
/// 2008, section IV-D), without a patch to find it by; nothing where the lens sees nothing.
/// @param rho [1/m]
std::optional<MonoState::Seed> raySeed(const Eigen::Vector2d& pixel, const PlanarCamera& camera,
                                       const Pose2& T_map_base, double rho);

/// The same with its patch; nothing as well where the image ends too near, or shows no corner.
std::optional<MonoState::Seed> seedAt(const Eigen::Vector2d& pixel, const cv::Mat& gray,
                                      const PlanarCamera& camera, const Pose2& T_map_base,
                                      double rho);

}  // namespace slam::mono_ekf
