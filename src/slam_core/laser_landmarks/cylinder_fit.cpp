// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/cylinder_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "slam_core/geometry/angle.hpp"

namespace slam::laser_landmarks {
namespace {

using Beams = std::vector<LaserBeam>;

constexpr int kMostSteps = 20;
constexpr double kConverged = 1e-6;    // [m, rad]
constexpr double kLeastRadius = 1e-3;  // [m]
constexpr double kInner = 0.85;  // of a circle's half width; beams farther out graze the circle
constexpr double kMostOblique = 0.95;  // sine of the angle at which a beam meets the circle
/// Range, bearing and radius (D, beta, rho).
using State = Eigen::Vector3d;

/// A residual divided by its standard deviation, with its derivative with respect to the state.
struct Residual {
  double value = 0.0;
  Eigen::RowVector3d J = Eigen::RowVector3d::Zero();
};

/// The range of a beam at the angle phi from the axis: D cos(phi) - sqrt(rho^2 - D^2 sin^2(phi)).
Residual beamResidual(const State& x, const LaserBeam& beam, const BeamNoise& noise) {
  const double D = x(0), rho = x(2), most_sine = kMostOblique * rho / D;
  const double sine = std::clamp(std::sin(wrapAngle(beam.bearing - x(1))), -most_sine, most_sine);
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double half_chord = std::sqrt(rho * rho - D * D * sine * sine);
  const double slope = D * sine * (D * cosine / half_chord - 1.0);  // in phi
  const double sigma = std::sqrt(noise.rangeVariance(beam.range) +
                                 slope * slope * noise.sigma_bearing * noise.sigma_bearing);
  Residual residual;
  residual.value = (beam.range - (D * cosine - half_chord)) / sigma;
  residual.J << cosine + D * sine * sine / half_chord, -slope, -rho / half_chord;
  residual.J /= sigma;
  return residual;
}

/// The beams that do not graze the circle, judged by their position within its width. At an edge
/// the derivative of the range is unbounded, and the bearing of the edge carries more information.
Beams inner(const Beams& beams, double spacing) {
  const double middle = (beams.front().bearing + beams.back().bearing) / 2.0;
  const double half_width = (beams.back().bearing - beams.front().bearing + spacing) / 2.0;
  Beams chosen;
  std::copy_if(beams.begin(), beams.end(), std::back_inserter(chosen), [&](const auto& beam) {
    return std::abs(beam.bearing - middle) < kInner * half_width;
  });
  return chosen;
}

/// @param side +1: the edge at the larger bearing, -1: the other
Residual edgeResidual(const State& x, double edge, double side, double sigma) {
  const double D = x(0), rho = x(2), tangent = std::sqrt(D * D - rho * rho);
  Residual residual;
  residual.value = wrapAngle(edge - x(1) - side * std::asin(rho / D)) / sigma;
  residual.J << -side * rho / (D * tangent), 1.0, side / tangent;
  residual.J /= sigma;
  return residual;
}

/// Normal equations of the least squares.
struct Normal {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  State gradient = State::Zero();
  double sum = 0.0;  // of the squared residuals
  std::size_t beams = 0;

  void add(const Residual& residual) {
    information += residual.J.transpose() * residual.J;
    gradient += residual.J.transpose() * residual.value;
    sum += residual.value * residual.value;
  }
};

Normal normalAt(const State& x, const Beams& beams, double spacing, const BeamNoise& noise) {
  Normal normal;
  const Beams used = inner(beams, spacing);
  for (const auto& beam : used) normal.add(beamResidual(x, beam, noise));
  normal.beams = used.size();
  const double sigma = std::sqrt(noise.edgeVariance(spacing));
  normal.add(edgeResidual(x, beams.front().bearing - spacing / 2.0, -1.0, sigma));
  normal.add(edgeResidual(x, beams.back().bearing + spacing / 2.0, 1.0, sigma));
  return normal;
}

/// The circle stays in front of the sensor.
State confined(State x) {
  x(2) = std::max(x(2), kLeastRadius);
  x(0) = std::max(x(0), 1.01 * x(2));
  return x;
}

}  // namespace

Cylinder cylinderOfWidth(const Beams& beams, double spacing) {
  double nearest = beams.front().range;
  for (const auto& beam : beams) nearest = std::min<double>(nearest, beam.range);
  const double width = beams.back().bearing - beams.front().bearing + spacing;
  const double sine = std::sin(std::min(width / 2.0, 1.2));
  Cylinder cylinder;
  cylinder.radius = nearest * sine / (1.0 - sine);
  cylinder.range = nearest + cylinder.radius;
  cylinder.bearing = wrapAngle((beams.front().bearing + beams.back().bearing) / 2.0);
  return cylinder;
}

std::optional<Cylinder> fitCylinder(const Beams& beams, double spacing, const BeamNoise& noise) {
  const Cylinder start = cylinderOfWidth(beams, spacing);
  State x = confined({start.range, start.bearing, start.radius});
  double step = 1.0;
  for (int i = 0; i < kMostSteps && step > kConverged; ++i) {
    const Normal normal = normalAt(x, beams, spacing, noise);
    const State delta = normal.information.ldlt().solve(normal.gradient);
    if (!delta.allFinite()) return std::nullopt;
    const State next = confined(x + delta);
    step = (next - x).norm();
    x = next;
  }
  const Normal normal = normalAt(x, beams, spacing, noise);
  const Eigen::LLT<Eigen::Matrix3d> factor(normal.information);
  if (!(step < std::sqrt(kConverged)) || factor.info() != Eigen::Success) return std::nullopt;
  const double dof = static_cast<double>(normal.beams) + 2.0 - 3.0;  // two edges, three values
  Cylinder cylinder{x(0), wrapAngle(x(1)), x(2), {}, misfitOf(normal.sum, dof)};
  const Eigen::Matrix3d P = factor.solve(Eigen::Matrix3d::Identity());
  cylinder.covariance = P.topLeftCorner<2, 2>();
  cylinder.sigma_radius = std::sqrt(P(2, 2));
  return cylinder;
}

}  // namespace slam::laser_landmarks
