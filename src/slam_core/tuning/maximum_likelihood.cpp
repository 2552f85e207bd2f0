// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/maximum_likelihood.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

// Symbols: x logarithms of the parameters, G the slopes of the steps (a row each), g their sum.

namespace slam::tuning {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSlopeStep = 0.03;  ///< of a logarithm: over the small kinks that gates make
constexpr double kLongestStep = 1.0;
constexpr double kSmallestGain = 0.01;  ///< of the log-likelihood: far less than what is certain
constexpr int kMostSteps = 40, kMostHalvings = 6, kMostDoublings = 3;

double sumOf(const VectorXd& values) {
  const double sum = values.sum();
  return std::isfinite(sum) ? sum : -std::numeric_limits<double>::infinity();
}

VectorXd shifted(const VectorXd& x, Index i, double by) {
  VectorXd moved = x;
  moved(i) += by;
  return moved;
}

MatrixXd slopesAt(const LogLikelihoods& f, const VectorXd& x) {
  MatrixXd G;
  for (Index i = 0; i < x.size(); ++i) {
    const VectorXd slopes =
        (f(shifted(x, i, kSlopeStep)) - f(shifted(x, i, -kSlopeStep))) / (2.0 * kSlopeStep);
    if (G.size() == 0) G.resize(slopes.size(), x.size());
    G.col(i) = slopes.unaryExpr([](double s) { return std::isfinite(s) ? s : 0.0; });
  }
  return G;
}

VectorXd direction(const MatrixXd& information, const VectorXd& g) {
  // What can hardly be seen is not thrown about.
  constexpr double kDamping = 0.1;
  const MatrixXd damped = information + kDamping * MatrixXd::Identity(g.size(), g.size());
  const VectorXd step = damped.llt().solve(g);
  return step * std::min(1.0, kLongestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
}

/// Where along a direction: halved until it is better, else doubled while it gets better.
class LineSearch {
 public:
  LineSearch(const LogLikelihoods& f, const VectorXd& x, double value, const VectorXd& step)
      : f_(f), x_(x), step_(step), value_(value) {
    double length = 1.0;
    for (int i = 0; i <= kMostHalvings && !tryLength(length); ++i) length *= 0.5;
    if (length_ < 1.0) return;
    const double longest = kLongestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12);
    for (int i = 0; i < kMostDoublings && 2.0 * length_ <= longest; ++i)
      if (!tryLength(2.0 * length_)) return;
  }
  VectorXd x() const { return x_ + length_ * step_; }
  double value() const { return value_; }

 private:
  bool tryLength(double length) {
    const double value = sumOf(f_(x_ + length * step_));
    if (!(value > value_)) return false;
    value_ = value;
    length_ = length;
    return true;
  }

  const LogLikelihoods& f_;
  const VectorXd& x_;
  const VectorXd& step_;
  double value_, length_ = 0.0;
};

}  // namespace

Maximum maximize(const LogLikelihoods& f, const VectorXd& start) {
  Maximum best;
  best.log_parameters = start;
  best.log_likelihood = sumOf(f(start));
  for (int i = 0; i < kMostSteps && !best.has_converged; ++i) {
    const MatrixXd G = slopesAt(f, best.log_parameters);
    best.information = G.transpose() * G;
    const VectorXd step = direction(best.information, G.colwise().sum().transpose());
    const LineSearch found(f, best.log_parameters, best.log_likelihood, step);
    best.has_converged = found.value() - best.log_likelihood < kSmallestGain;
    best.log_parameters = found.x();
    best.log_likelihood = found.value();
  }
  return best;
}

VectorXd conditionalSigmas(const MatrixXd& information) {
  return information.diagonal().unaryExpr([](double i) {
    return i > 0.0 ? 1.0 / std::sqrt(i) : std::numeric_limits<double>::infinity();
  });
}

VectorXd marginalSigmas(const MatrixXd& information) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(information);
  // A direction in which the likelihood does not fall is not told at all.
  const VectorXd inverse =
      solver.eigenvalues().unaryExpr([](double value) { return value > 1e-6 ? 1.0 / value : 1e6; });
  const MatrixXd covariance =
      solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
  return covariance.diagonal().cwiseSqrt();
}

}  // namespace slam::tuning
