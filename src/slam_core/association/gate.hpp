// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace slam::association {

/// The largest squared Mahalanobis distance of an innovation in range and bearing that passes the
/// gate: the quantile of the chi-square distribution with two degrees of freedom.
/// @param probability that a right observation passes, in (0, 1)
double gateOf(double probability);

/// The same of several innovations together: the quantile with two degrees of freedom for each of
/// `observations`, which is not 0.
double jointGateOf(double probability, std::size_t observations);

/// The logarithm of the density of an innovation outside the gate, from its squared Mahalanobis
/// distance: N(nu; 0, S) at the gate, and from there it falls like a power that keeps the normal
/// distribution's share of all innovations outside. So it is a density with any gate, the values
/// of S that are most likely do not depend on the gate, and an outlier costs more the smaller S is.
double outlierLogLikelihood(double gate, double nis, const Eigen::Matrix2d& S);

}  // namespace slam::association
