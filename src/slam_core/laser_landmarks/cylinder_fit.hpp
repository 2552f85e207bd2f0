// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam_core/laser_landmarks/beam_noise.hpp"

namespace slam::laser_landmarks {

/// An upright cylinder as a horizontal laser sees it: a circle.
struct Cylinder {
  double range = 0.0;    ///< of its axis from the sensor [m]
  double bearing = 0.0;  ///< of its axis [rad]
  double radius = 0.0;   ///< [m]
  /// of (range, bearing) [m^2, m rad, rad^2], whatever the radius is
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double misfit = 0.0;        ///< see misfitOf()
  double sigma_radius = 0.0;  ///< [m]
};

/// The circle that the angular width of the beams tells: r s / (1 - s) is its radius, with r the
/// shortest range and s the sine of half the width (Guivant, Nebot 2001).
Cylinder cylinderOfWidth(const std::vector<LaserBeam>& beams, double spacing);

/// The circle that fits best, by least squares over the ranges of the beams that do not graze it
/// and over the two edges, each of which lies between its last beam and the next: a uniform error
/// of the spacing. Where the circle curves away from the beams, an error of their direction is one
/// of range.
/// @param beams of one thing, by rising bearing, two at least; nothing hides a part of it
/// @param spacing between beams of the sweep [rad]
/// @return nothing where no circle fits
std::optional<Cylinder> fitCylinder(const std::vector<LaserBeam>& beams, double spacing,
                                    const BeamNoise& noise);

}  // namespace slam::laser_landmarks
