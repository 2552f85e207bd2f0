// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/mono_ekf/feature.hpp"

namespace slam::mono_ekf {

/// Errors of the state as a right-invariant EKF has them (Barrau and Bonnabel 2015; Zhang et al.
/// 2017), here on similarity transforms of the plane. No image shows where the map as a whole
/// points to, nor how large it is. An EKF whose Jacobians are taken at places that its own updates
/// move forgets that, and becomes sure of a heading and of a scale that nothing has measured
/// (Huang, Mourikis, Roumeliotis 2010). Here an error of the heading turns the whole map with the
/// robot, and an error of the scale enlarges it, wherever the estimates are:
///
///     theta = theta^ + alpha,   p = exp(s) R(alpha) p^ + W u                  (1)
///     rho = exp(-s) rho^ + ...,   z - h = exp(s) (z^ - h) + ...
///
/// for the position p of the robot and that of each feature, the inverse depth rho of a feature,
/// and the height z of a point above the camera's height h. The state's covariance is that of
/// dp = u + (alpha J + s) p^ (J turns by 90 degrees), the first order of (1), so that it reads as
/// usual; when an update moves p^ by d, dp becomes dp + (alpha J + s) d. As complex numbers,
///
///     p = p^ + W dp,   W = (exp(lambda) - 1) / lambda,   lambda = s + i alpha  (2)
struct MapStep {
  double alpha = 0.0;  ///< [rad]
  double s = 0.0;      ///< logarithm of the scale
};

/// A vector turned by 90 degrees: d p / d alpha of a position p.
inline Eigen::Vector2d turnedLeft(const Eigen::Vector2d& vector) {
  return {-vector.y(), vector.x()};
}

/// A position after a step dp (2).
Eigen::Vector2d stepped(const Eigen::Vector2d& position, const Eigen::Vector2d& dp,
                        const MapStep& map);
/// The dp of the step from one position to another.
Eigen::Vector2d stepBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            const MapStep& map);

/// These two do the same for all coordinates of a feature.
Eigen::VectorXd stepped(const Feature& feature, const Eigen::VectorXd& coordinates,
                        const Eigen::VectorXd& step, const MapStep& map);
Eigen::VectorXd stepBetween(const Feature& feature, const Eigen::VectorXd& from,
                            const Eigen::VectorXd& to, const MapStep& map);

/// If the estimate of a feature moves by this, its error grows by alpha times the first of these,
/// and by s times the second one.
Eigen::VectorXd addedByHeading(const Eigen::VectorXd& moved);
Eigen::VectorXd addedByScale(const Feature& feature, const Eigen::VectorXd& moved);

}  // namespace slam::mono_ekf
