// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam::mono_ekf {

/// Errors of the state as a right-invariant EKF has them (Barrau and Bonnabel 2015; Zhang et al.
/// 2017). No image shows where the map as a whole points to. An EKF whose Jacobians are taken at
/// places that its own updates move forgets that, and becomes sure of a heading that nothing has
/// measured (Huang, Mourikis, Roumeliotis 2010). Here an error of the heading turns the whole map
/// with the robot, wherever the estimates are:
///
///     theta = theta^ + alpha,   p = R(alpha) p^ + V(alpha) u                  (1)
///
/// for the position p of the robot and that of each feature, with V of SE(2)'s exponential map. The
/// state's covariance is that of dp = u + alpha J p^ (J turns by 90 degrees), the first order of
/// (1), so that it reads as usual; when an update moves p^ by d, dp becomes dp + alpha J d.

/// A vector turned by 90 degrees: d p / d alpha of a position p.
inline Eigen::Vector2d turnedLeft(const Eigen::Vector2d& vector) {
  return {-vector.y(), vector.x()};
}
/// A position (1) after a step (dp, alpha).
Eigen::Vector2d stepped(const Eigen::Vector2d& position, const Eigen::Vector2d& step, double alpha);
/// The dp of the step from one position to another with alpha.
Eigen::Vector2d stepBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double alpha);

}  // namespace slam::mono_ekf
