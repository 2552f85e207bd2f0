// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam_core/laser_landmarks/beam_noise.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::laser_landmarks {

/// A straight line as a horizontal laser sees it.
struct Line {
  double range = 0.0;    ///< length of the perpendicular from the sensor [m]
  double bearing = 0.0;  ///< direction of the perpendicular [rad]
  /// of (range, bearing) [m^2, m rad, rad^2]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  LineExtent extent;    ///< where its outermost beams meet it [m]
  double misfit = 0.0;  ///< see misfitOf()

  double length() const { return extent.end - extent.begin; }
  /// The unit vectors of the perpendicular and along the line.
  Eigen::Vector2d normal() const;
  Eigen::Vector2d along() const;
};

/// The line of maximum likelihood: total least squares, each beam's end weighted by its variance
/// across the line, to which its range and its direction contribute by the angle at which the beam
/// meets the line (Pfister, Roumeliotis, Burdick 2003; Siegwart, Nourbakhsh 2004, ch. 4.3.1).
/// @param beams that end on one line, by rising bearing
/// @return nothing where they are fewer than three, or do not determine a line
std::optional<Line> fitLine(const std::vector<LaserBeam>& beams, const BeamNoise& noise);

/// The point where two lines cross.
struct Crossing {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    ///< in the sensor's frame [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the position [m^2]
};
/// @return nothing where the lines are parallel
std::optional<Crossing> crossingOf(const Line& a, const Line& b);

}  // namespace slam::laser_landmarks
