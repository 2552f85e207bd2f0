// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "slam_core/mono_graph/visual_map.hpp"

namespace slam::mono_graph {

/// The point that two rays meet in: the middle of where they are nearest. Nothing where the rays
/// are nearly parallel or meet behind the cameras.
/// @param least_parallax between the rays [rad]
std::optional<Eigen::Vector3d> intersectionOf(const Eigen::Vector3d& centre_a,
                                              const Eigen::Vector3d& ray_a,
                                              const Eigen::Vector3d& centre_b,
                                              const Eigen::Vector3d& ray_b, double least_parallax);

/// New points from two keyframes: features of either that are of no point yet, match by descriptor
/// along the epipolar line, and meet in a point that both see where it is (Mur-Artal et al. 2015,
/// VI.C). Each has the sightings of both, that of `now` first.
std::vector<MapPoint> triangulate(const VisualMap& map, int now, int before);

/// The covariance of a point's position [m^2] by the keyframes that see it, those taken as exact.
Eigen::Matrix3d covarianceOf(const VisualMap& map, const MapPoint& point);

}  // namespace slam::mono_graph
