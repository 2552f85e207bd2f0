// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/line_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

// Symbols: n the unit normal of the line, t the unit vector along it, p a point on it, w the sum of
// the weights of the beams' ends, P the covariance of range and bearing.

namespace slam::laser_landmarks {
namespace {

using Beams = std::vector<LaserBeam>;

constexpr int kIterations = 4;         // of the weights, which depend on the line's direction
constexpr double kLeastSine = 1e-3;    // of the angle between two lines; below, they are parallel
constexpr double kLeastSpread = 1e-3;  // of the ends along a line [m]

/// Weighted moments of the ends of beams about their centre.
struct Moments {
  double weight = 0.0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

template <class Weight>
Moments momentsOf(const Beams& beams, const Weight& weight) {
  Moments m;
  for (const auto& beam : beams) {
    m.weight += weight(beam);
    m.centre += weight(beam) * beam.end();
  }
  m.centre /= m.weight;
  for (const auto& beam : beams) {
    const Eigen::Vector2d d = beam.end() - m.centre;
    m.xx += weight(beam) * d.x() * d.x();
    m.xy += weight(beam) * d.x() * d.y();
    m.yy += weight(beam) * d.y() * d.y();
  }
  return m;
}

/// The bearing of the normal that points from the sensor to the line through the centre [rad].
double perpendicularOf(const Moments& m) {
  const double along = 0.5 * std::atan2(2.0 * m.xy, m.xx - m.yy);
  const double bearing = along + M_PI / 2.0;
  const Eigen::Vector2d n(std::cos(bearing), std::sin(bearing));
  return wrapAngle(n.dot(m.centre) >= 0.0 ? bearing : bearing + M_PI);
}

/// The variance of a beam's end across a line [m^2].
double varianceAcross(const LaserBeam& beam, double bearing, const BeamNoise& noise) {
  const double angle = beam.bearing - bearing, cosine = std::cos(angle), sine = std::sin(angle);
  const double sideways = beam.range * noise.sigma_bearing;
  return noise.rangeVariance(beam.range) * cosine * cosine + sideways * sideways * sine * sine;
}

/// The covariance of range and bearing. An error of the direction turns the line about the centre
/// of its ends, and so moves the foot of the perpendicular as well.
Eigen::Matrix2d covarianceOf(const Line& line, const Moments& m) {
  const Eigen::Vector2d t = line.along();
  const double spread = t.x() * t.x() * m.xx + 2.0 * t.x() * t.y() * m.xy + t.y() * t.y() * m.yy;
  const double of_bearing = 1.0 / spread, lever = t.dot(m.centre);
  Eigen::Matrix2d P;
  P << 1.0 / m.weight + lever * lever * of_bearing, lever * of_bearing, lever * of_bearing,
      of_bearing;
  return P;
}

/// The coordinate along the line of the point where a beam crosses it, from the foot of the
/// perpendicular [m].
double placeOf(const LaserBeam& beam, const Line& line) {
  return line.range * std::tan(wrapAngle(beam.bearing - line.bearing));
}

}  // namespace

Eigen::Vector2d Line::normal() const { return {std::cos(bearing), std::sin(bearing)}; }

Eigen::Vector2d Line::along() const { return {-std::sin(bearing), std::cos(bearing)}; }

std::optional<Line> fitLine(const Beams& beams, const BeamNoise& noise) {
  if (beams.size() < 3) return std::nullopt;
  Moments m = momentsOf(beams, [](const LaserBeam&) { return 1.0; });
  if (std::hypot(m.xx, m.yy) < kLeastSpread * kLeastSpread) return std::nullopt;
  Line line;
  line.bearing = perpendicularOf(m);
  for (int i = 0; i < kIterations; ++i) {
    const double bearing = line.bearing;
    m = momentsOf(beams, [&](const auto& b) { return 1.0 / varianceAcross(b, bearing, noise); });
    line.bearing = perpendicularOf(m);
  }
  line.range = line.normal().dot(m.centre);
  if (!(line.range > 0.0)) return std::nullopt;
  line.covariance = covarianceOf(line, m);
  double sum = 0.0;
  for (const auto& beam : beams)
    sum += std::pow(line.normal().dot(beam.end()) - line.range, 2) /
           varianceAcross(beam, line.bearing, noise);
  line.misfit = misfitOf(sum, static_cast<double>(beams.size()) - 2.0);
  line.extent = {placeOf(beams.front(), line), placeOf(beams.back(), line)};
  return line.covariance.allFinite() ? std::optional(line) : std::nullopt;
}

std::optional<Crossing> crossingOf(const Line& a, const Line& b) {
  Eigen::Matrix2d N;
  N << a.normal().transpose(), b.normal().transpose();
  if (std::abs(N.determinant()) < kLeastSine) return std::nullopt;
  const Eigen::Matrix2d inverse = N.inverse();
  Crossing crossing;
  crossing.position = inverse * Eigen::Vector2d(a.range, b.range);
  // the differential of n p = range: n dp = d range - (t p) d bearing
  const auto variance = [&](const Line& line) {
    const Eigen::RowVector2d J(1.0, -line.along().dot(crossing.position));
    return (J * line.covariance * J.transpose()).value();
  };
  const Eigen::Vector2d variances(variance(a), variance(b));
  crossing.covariance = inverse * variances.asDiagonal() * inverse.transpose();
  return crossing;
}

}  // namespace slam::laser_landmarks
