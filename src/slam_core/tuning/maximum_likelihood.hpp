// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <functional>

namespace slam::tuning {

/// The log-likelihood of each step of a run given all steps before it, by the logarithms of
/// parameters that are all positive. The number of steps is always the same.
using LogLikelihoods = std::function<Eigen::VectorXd(const Eigen::VectorXd& log_parameters)>;

/// Where the sum over the steps has its maximum.
struct Maximum {
  Eigen::VectorXd log_parameters;
  Eigen::MatrixXd information;  ///< the curvature of the sum there, downwards
  Eigen::VectorXd sigmas;       ///< standard deviation of each logarithm, the others unknown
  double log_likelihood = 0.0;
  bool has_converged = false;
};

/// Ascent along the slope as weighed by the sum of the outer products of the steps' slopes (Berndt,
/// Hall, Hall, Hausman 1974), and by the curvature near the maximum; both are numeric. A step
/// never changes a parameter by more than a factor of e. What is not finite counts as -inf.
/// The uncertainty holds where the model does not: the outer products between two inverses of the
/// curvature (White 1982), of blocks of steps, as the slopes of neighbours are alike (Newey and
/// West 1987). It is never less than the inverse of the curvature.
/// @param start must have a finite likelihood
Maximum maximize(const LogLikelihoods& f, const Eigen::VectorXd& start);

/// The standard deviation of each logarithm with the others known: more than 1 says that the data
/// hardly tell its order of magnitude.
Eigen::VectorXd conditionalSigmas(const Eigen::MatrixXd& information);

}  // namespace slam::tuning
