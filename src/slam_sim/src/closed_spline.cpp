// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/closed_spline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slam::sim {
namespace {

constexpr double kTableStep = 0.01;    // [m]
constexpr int kIntervalsPerKnot = 64;  // of the integration of the length

}  // namespace

ClosedSpline::ClosedSpline(const std::vector<Eigen::Vector2d> &points) : points_(points) {
  points_.push_back(points.front());
  knots_.push_back(0.0);
  for (std::size_t i = 1; i < points_.size(); ++i)
    knots_.push_back(knots_.back() + (points_[i] - points_[i - 1]).norm());
  solveSecondDerivatives();
  tabulate();
}

/// The first derivative is continuous at every knot (de Boor 1978, ch. IV, periodic end).
void ClosedSpline::solveSecondDerivatives() {
  const auto n = static_cast<Eigen::Index>(points_.size()) - 1;
  const auto interval = [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>((i + n) % n);
    return knots_[k + 1] - knots_[k];
  };
  const auto slope = [&](Eigen::Index i) -> Eigen::RowVector2d {
    const auto k = static_cast<std::size_t>((i + n) % n);
    return (points_[k + 1] - points_[k]).transpose() / interval(i);
  };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX2d b(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    A(i, (i + n - 1) % n) += interval(i - 1);
    A(i, i) += 2.0 * (interval(i - 1) + interval(i));
    A(i, (i + 1) % n) += interval(i);
    b.row(i) = 6.0 * (slope(i) - slope(i - 1));
  }
  const Eigen::MatrixX2d m = A.partialPivLu().solve(b);
  for (Eigen::Index i = 0; i <= n; ++i) seconds_.emplace_back(m.row(i % n).transpose());
}

ClosedSpline::Derivatives ClosedSpline::at(double u) const {
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, u);
  const auto i = static_cast<std::size_t>(next - knots_.begin()) - 1;
  const double h = knots_[i + 1] - knots_[i];
  const double b = (u - knots_[i]) / h, a = 1.0 - b;
  const Eigen::Vector2d &p0 = points_[i], &p1 = points_[i + 1];
  const Eigen::Vector2d &m0 = seconds_[i], &m1 = seconds_[i + 1];
  return {a * p0 + b * p1 + h * h / 6.0 * ((a * a * a - a) * m0 + (b * b * b - b) * m1),
          (p1 - p0) / h + h / 6.0 * ((1.0 - 3.0 * a * a) * m0 + (3.0 * b * b - 1.0) * m1),
          a * m0 + b * m1};
}

/// The length by Simpson's rule, then u(s) by integrating du/ds = 1/|c'(u)| (Runge-Kutta).
void ClosedSpline::tabulate() {
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double h = (knots_[i + 1] - knots_[i]) / kIntervalsPerKnot;
    for (int k = 0; k < kIntervalsPerKnot; ++k) {
      const double u = knots_[i] + k * h;
      length_ += h / 6.0 * (speed(u) + 4.0 * speed(u + h / 2.0) + speed(u + h));
    }
  }
  const auto steps = static_cast<std::size_t>(std::ceil(length_ / kTableStep));
  step_ = length_ / static_cast<double>(steps);
  double u = 0.0;
  for (std::size_t i = 0; i < steps; ++i) {
    parameters_.push_back(u);
    const double k1 = 1.0 / speed(u), k2 = 1.0 / speed(u + step_ / 2.0 * k1);
    const double k3 = 1.0 / speed(u + step_ / 2.0 * k2), k4 = 1.0 / speed(u + step_ * k3);
    u += step_ / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  parameters_.push_back(knots_.back());
}

/// Cubic Hermite interpolation of the table: smooth, so that speeds are.
double ClosedSpline::parameter(double s) const {
  const double wrapped = s - length_ * std::floor(s / length_);
  const auto last = parameters_.size() - 2;
  const auto i = std::min(static_cast<std::size_t>(wrapped / step_), last);
  const double t = wrapped / step_ - static_cast<double>(i);
  const double u0 = parameters_[i], u1 = parameters_[i + 1];
  const double d0 = step_ / speed(u0), d1 = step_ / speed(u1);
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * u0 + (t3 - 2.0 * t2 + t) * d0 + (3.0 * t2 - 2.0 * t3) * u1 +
         (t3 - t2) * d1;
}

Eigen::Vector2d ClosedSpline::point(double s) const { return at(parameter(s)).value; }

double ClosedSpline::heading(double s) const {
  const Eigen::Vector2d tangent = at(parameter(s)).first;
  return std::atan2(tangent.y(), tangent.x());
}

double ClosedSpline::curvature(double s) const {
  const auto c = at(parameter(s));
  const double norm = c.first.norm();
  return (c.first.x() * c.second.y() - c.first.y() * c.second.x()) / (norm * norm * norm);
}

}  // namespace slam::sim
