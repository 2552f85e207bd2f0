// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam::mono_ekf {

/// A point by where it was seen first (Civera, Davison and Montiel 2008): (x, y) of the camera's
/// centre then [m], azimuth and elevation of the ray [rad], inverse of the distance rho [1/m]. Map
/// frame. The height of the camera's centre, which is known on a robot in the plane, stands beside
/// it.
using InverseDepth = Eigen::Matrix<double, 5, 1>;

/// The direction of a ray, of length 1 (Eq. 6 there, for a z axis that points up), with the 3x2
/// Jacobian in (azimuth, elevation).
Eigen::Vector3d directionOf(double azimuth, double elevation,
                            Eigen::Matrix<double, 3, 2>* J = nullptr);

/// The point (x, y, z) = centre + direction / rho (Eq. 3), with the 3x5 Jacobian.
/// @pre rho is not zero
Eigen::Vector3d pointOf(const InverseDepth& feature, double height,
                        Eigen::Matrix<double, 3, 5>* J = nullptr);

/// rho (point - centre now): the vector from the camera to the point, scaled so that it exists at
/// infinity as well (Eq. 11), with the 3x5 Jacobian in the feature; that in the centre now is
/// -rho I.
Eigen::Vector3d scaledVector(const InverseDepth& feature, double height,
                             const Eigen::Vector3d& centre_now,
                             Eigen::Matrix<double, 3, 5>* J = nullptr);

/// The linearity index (Eq. 31): below 0.1 a Gaussian along the ray is nearly one in metres, and
/// the point is as good as its inverse depth. It is infinite where rho is not positive.
/// @param sigma_rho standard deviation of rho [1/m]
double linearityIndex(const InverseDepth& feature, double height, double sigma_rho,
                      const Eigen::Vector3d& centre_now);

}  // namespace slam::mono_ekf
