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
  /// of (range, bearing) [m^2, m rad, rad^2], marginal over the radius
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double misfit = 0.0;        ///< see misfitOf()
  double sigma_radius = 0.0;  ///< [m]
};

/// The circle that follows from the angular width of the beams: its radius is r s / (1 - s), with r
/// the shortest range and s the sine of half the width (Guivant, Nebot 2001).
Cylinder cylinderOfWidth(const std::vector<LaserBeam>& beams, double spacing);

/// The circle that fits best, by least squares over the ranges of the beams that do not graze it
/// and over the bearings of the two edges (BeamNoise::edgeVariance()). Where a beam meets the
/// circle obliquely, an error of its direction is also one of its range.
/// @param beams of one object, by rising bearing, at least one; no part of the object is hidden
/// @param spacing between beams of the sweep [rad]
/// @return nothing where the fit does not converge
std::optional<Cylinder> fitCylinder(const std::vector<LaserBeam>& beams, double spacing,
                                    const BeamNoise& noise);

}  // namespace slam::laser_landmarks
