// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/maximum_likelihood.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

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

/// What two looks along each axis tell.
struct Slopes {
  MatrixXd G;
  VectorXd sides;  ///< the sums at both looks, together
};

Slopes slopesAt(const LogLikelihoods& f, const VectorXd& x) {
  Slopes slopes{{}, VectorXd(x.size())};
  for (Index i = 0; i < x.size(); ++i) {
    const VectorXd up = f(shifted(x, i, kSlopeStep)), down = f(shifted(x, i, -kSlopeStep));
    if (slopes.G.size() == 0) slopes.G.resize(up.size(), x.size());
    slopes.G.col(i) = ((up - down) / (2.0 * kSlopeStep)).unaryExpr(&finite);
    slopes.sides(i) = sumOf(up) + sumOf(down);
  }
  return slopes;
}

/// The mixed terms from two looks along each diagonal.
MatrixXd curvatureAt(const LogLikelihoods& f, const VectorXd& x, double value,
                     const VectorXd& sides) {
  constexpr double kArea = kSlopeStep * kSlopeStep;
  const auto diagonal = [&](Index i, Index j, double by) {
    return sumOf(f(shifted(shifted(x, i, by), j, by)));
  };
  MatrixXd H(x.size(), x.size());
  for (Index i = 0; i < x.size(); ++i) {
    H(i, i) = finite((2.0 * value - sides(i)) / kArea);
    for (Index j = 0; j < i; ++j) {
      const double both = diagonal(i, j, kSlopeStep) + diagonal(i, j, -kSlopeStep);
      H(i, j) = H(j, i) = finite((sides(i) + sides(j) - both - 2.0 * value) / (2.0 * kArea));
    }
  }
  return H;
}

VectorXd direction(const MatrixXd& information, const VectorXd& g) {
  // What can hardly be seen is not thrown about, and where the curvature is upwards the way is up.
  constexpr double kDamping = 0.1;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(information);
  const VectorXd weights = solver.eigenvalues().cwiseAbs().array() + kDamping;
  const VectorXd step =
      solver.eigenvectors() * (solver.eigenvectors().transpose() * g).cwiseQuotient(weights);
  return step * std::min(1.0, kLongestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
}

/// The sum of the outer products of the slopes of whole stretches: what neighbouring steps have in
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
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(information);
  // A direction in which the likelihood does not fall is not told at all.
  const VectorXd inverse =
      solver.eigenvalues().unaryExpr([](double value) { return value > 1e-6 ? 1.0 / value : 1e6; });
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

VectorXd sigmasOf(const MatrixXd& H, const MatrixXd& G) {
  const MatrixXd inverse = inverseOf(H);
  const MatrixXd sandwich = inverse * clusteredSquares(G) * inverse;
  // Few stretches may be alike by chance: nothing is surer than where the model is right.
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
    const auto slopes = slopesAt(f, x);
    if (!is_near) {
      best.information = slopes.G.transpose() * slopes.G;
    } else if (curved_at.size() == 0 || (x - curved_at).cwiseAbs().maxCoeff() > kStale) {
      best.information = curvatureAt(f, x, best.log_likelihood, slopes.sides);
      curved_at = x;
    }
    best.sigmas = sigmasOf(best.information, slopes.G);
    const VectorXd step = direction(best.information, slopes.G.colwise().sum().transpose());
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
