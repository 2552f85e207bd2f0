// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/maximum_likelihood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/geometry/principal_axes.hpp"

// Symbols: x logarithms of the parameters, G the slopes of the steps (a row each), g their sum, H
// the curvature of the sum, downwards.

namespace slam::tuning {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSlopeStep = 0.1;  ///< of a logarithm: over the small kinks that gates make
constexpr double kLongestStep = 1.0;
constexpr double kSmallestGain = 0.01;  ///< of the log-likelihood: far less than what is certain
constexpr double kNear = 1.0;           ///< where steps gain less, the curvature takes over
constexpr double kStale = 0.3;          ///< of a logarithm: so far away it is computed anew
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

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

MatrixXd slopesAt(const LogLikelihoods& f, const VectorXd& x) {
  MatrixXd G;
  for (Index i = 0; i < x.size(); ++i) {
    const VectorXd slopes =
        (f(shifted(x, i, kSlopeStep)) - f(shifted(x, i, -kSlopeStep))) / (2.0 * kSlopeStep);
    if (G.size() == 0) G.resize(slopes.size(), x.size());
    G.col(i) = slopes.unaryExpr(&finite);
  }
  return G;
}

MatrixXd curvatureAt(const LogLikelihoods& f, const VectorXd& x, double value) {
  constexpr double kStep = 0.3;  // curvature is an order more sensitive to kinks than slopes are
  const auto both = [&](const VectorXd& step) { return sumOf(f(x + step)) + sumOf(f(x - step)); };
  const MatrixXd axes = kStep * MatrixXd::Identity(x.size(), x.size());
  MatrixXd H(x.size(), x.size());
  VectorXd sides(x.size());
  for (Index i = 0; i < x.size(); ++i) {
    sides(i) = both(axes.col(i));
    H(i, i) = finite((2.0 * value - sides(i)) / (kStep * kStep));
    for (Index j = 0; j < i; ++j) {
      const double diagonal = both(axes.col(i) + axes.col(j));
      H(i, j) = H(j, i) =
          finite((sides(i) + sides(j) - diagonal - 2.0 * value) / (2.0 * kStep * kStep));
    }
  }
  return H;
}

/// Along a direction in which kinks hide the curvature the outer products stand for it.
MatrixXd mended(const MatrixXd& H, const MatrixXd& squares) {
  constexpr double kHidden = 0.05;  // of the outer products: no outliers make so much of them
  const auto axes = principalAxes(H);
  const MatrixXd& V = axes.directions;
  const VectorXd instead = (V.transpose() * squares * V).diagonal();
  const VectorXd values =
      (axes.values.array() < kHidden * instead.array()).select(instead, axes.values);
  return V * values.asDiagonal() * V.transpose();
}

VectorXd direction(const MatrixXd& information, const VectorXd& g) {
  // What can hardly be seen is not thrown about.
  constexpr double kDamping = 0.1;
  const MatrixXd damped = information + kDamping * MatrixXd::Identity(g.size(), g.size());
  const VectorXd step = damped.ldlt().solve(g);
  return step * std::min(1.0, kLongestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
}

/// The sum of the outer products of the slopes of whole blocks: what neighbouring steps have in
/// common is counted as often as it is there.
MatrixXd clusteredSquares(const MatrixXd& G) {
  const auto length = static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(G.rows()))));
  const Eigen::RowVectorXd mean = G.colwise().mean();
  MatrixXd squares = MatrixXd::Zero(G.cols(), G.cols());
  Index clusters = 0;
  for (Index begin = 0; begin < G.rows(); begin += length, ++clusters) {
    const Index rows = std::min(length, G.rows() - begin);
    const Eigen::RowVectorXd sum =
        G.middleRows(begin, rows).colwise().sum() - static_cast<double>(rows) * mean;
    squares += sum.transpose() * sum;
  }
  return clusters < 2 ? squares : squares * (double(clusters) / double(clusters - 1));
}

MatrixXd inverseOf(const MatrixXd& information) {
  const auto axes = principalAxes(information);
  // A direction in which the likelihood does not fall is not determined at all.
  const VectorXd inverse =
      axes.values.unaryExpr([](double value) { return value > 1e-6 ? 1.0 / value : 1e6; });
  return axes.directions * inverse.asDiagonal() * axes.directions.transpose();
}

VectorXd sigmasOf(const MatrixXd& H, const MatrixXd& G) {
  const MatrixXd inverse = inverseOf(H);
  const MatrixXd sandwich = inverse * clusteredSquares(G) * inverse;
  // Few blocks may be alike by chance: nothing is surer than where the model is right.
  return sandwich.diagonal().cwiseMax(inverse.diagonal()).cwiseSqrt();
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
  VectorXd curved_at;  // empty while the maximum is far
  bool is_near = false;
  for (int i = 0; i < kMostSteps && !best.has_converged; ++i) {
    const auto& x = best.log_parameters;
    const MatrixXd G = slopesAt(f, x), squares = G.transpose() * G;
    if (!is_near) {
      best.information = squares;
    } else if (curved_at.size() == 0 || (x - curved_at).cwiseAbs().maxCoeff() > kStale) {
      best.information = mended(curvatureAt(f, x, best.log_likelihood), squares);
      curved_at = x;
    }
    best.sigmas = sigmasOf(best.information, G);
    const VectorXd step = direction(best.information, G.colwise().sum().transpose());
    const LineSearch found(f, x, best.log_likelihood, step);
    const double gain = found.value() - best.log_likelihood;
    best.has_converged = is_near && gain < kSmallestGain;
    is_near = is_near || gain < kNear;
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

}  // namespace slam::tuning
