// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// The standard deviations of a beam's range and direction.
struct BeamNoise {
  double sigma_range = 0.0;     ///< [m]
  double relative_sigma = 0.0;  ///< of a range, relative to it [1]
  double sigma_bearing = 0.0;   ///< [rad]

  /// The variance of a range [m^2].
  double rangeVariance(double range) const {
    const double relative = relative_sigma * range;
    return sigma_range * sigma_range + relative * relative;
  }
  /// The variance of an edge's bearing [rad^2]. The edge lies anywhere between the last beam on the
  /// object and the next beam, so that its error is uniform over the spacing.
  double edgeVariance(double spacing) const {
    return spacing * spacing / 12.0 + sigma_bearing * sigma_bearing;
  }
};

/// @return by how many standard deviations the residuals are larger than expected (Wilson, Hilferty
/// 1931)
/// @param sum of the squared normalised residuals; chi-square distributed where the model fits
/// @param dof degrees of freedom of that sum
inline double misfitOf(double sum, double dof) {
  const double of = std::max(dof, 1.0), spread = 2.0 / (9.0 * of);
  return (std::cbrt(sum / of) - (1.0 - spread)) / std::sqrt(spread);
}

}  // namespace slam::laser_landmarks
