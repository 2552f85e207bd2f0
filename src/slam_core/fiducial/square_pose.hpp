// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

namespace slam::fiducial {

/// The corners of a marker as one looks at it, clockwise from the upper left one.
using Corners = std::array<Eigen::Vector2d, 4>;

/// Of the sides, in the unit of the corners.
double meanSide(const Corners& corners);

/// The corners of a marker of the edge length `size` [m] in its own frame: x right, y up, z out of
/// the face towards who looks at it.
std::array<Eigen::Vector3d, 4> cornersOfSquare(double size);

/// The two poses T_camera_marker that explain four corners on the plane z = 1, in closed form: the
/// infinitesimal plane-based pose estimate (Collins and Bartoli 2014) at the centre of a square.
/// Nothing where three corners are in line. One pose may have corners behind the camera.
std::optional<std::array<Eigen::Isometry3d, 2>> posesOfSquare(const Corners& on_plane, double size);

}  // namespace slam::fiducial
