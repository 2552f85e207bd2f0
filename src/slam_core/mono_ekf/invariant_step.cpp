// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/invariant_step.hpp"

#include <cmath>
#include <complex>

namespace slam::mono_ekf {
namespace {

using Complex = std::complex<double>;

constexpr double kNearZero = 1e-5;

Complex growthOf(const MapStep& map) {
  const Complex lambda(map.s, map.alpha);
  return std::abs(lambda) < kNearZero ? 1.0 + 0.5 * lambda : (std::exp(lambda) - 1.0) / lambda;
}

/// A feature's last coordinate grows with the scale, or with one over it.
double lastGrowthOf(const Feature& feature, const MapStep& map) {
  const double s = feature.is_point ? map.s : -map.s;
  return std::abs(s) < kNearZero ? 1.0 + 0.5 * s : std::expm1(s) / s;
}

}  // namespace

Eigen::Vector2d stepped(const Eigen::Vector2d& position, const Eigen::Vector2d& dp,
                        const MapStep& map) {
  const Complex moved = growthOf(map) * Complex(dp.x(), dp.y());
  return position + Eigen::Vector2d(moved.real(), moved.imag());
}

Eigen::Vector2d stepBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            const MapStep& map) {
  const Eigen::Vector2d moved = to - from;
  const Complex dp = Complex(moved.x(), moved.y()) / growthOf(map);
  return {dp.real(), dp.imag()};
}

Eigen::VectorXd stepped(const Feature& feature, const Eigen::VectorXd& coordinates,
                        const Eigen::VectorXd& step, const MapStep& map) {
  const auto last = coordinates.size() - 1;
  Eigen::VectorXd after = coordinates + step;
  after.head<2>() = stepped(Eigen::Vector2d(coordinates.head<2>()), step.head<2>(), map);
  after(last) = coordinates(last) + lastGrowthOf(feature, map) * step(last);
  return after;
}

Eigen::VectorXd stepBetween(const Feature& feature, const Eigen::VectorXd& from,
                            const Eigen::VectorXd& to, const MapStep& map) {
  const auto last = from.size() - 1;
  Eigen::VectorXd step = to - from;
  step.head<2>() = stepBetween(Eigen::Vector2d(from.head<2>()), to.head<2>(), map);
  step(last) /= lastGrowthOf(feature, map);
  return step;
}

Eigen::VectorXd addedByHeading(const Eigen::VectorXd& moved) {
  Eigen::VectorXd added = Eigen::VectorXd::Zero(moved.size());
  added.head<2>() = turnedLeft(moved.head<2>());
  return added;
}

Eigen::VectorXd addedByScale(const Feature& feature, const Eigen::VectorXd& moved) {
  const auto last = moved.size() - 1;
  Eigen::VectorXd added = Eigen::VectorXd::Zero(moved.size());
  added.head<2>() = moved.head<2>();
  added(last) = feature.is_point ? moved(last) : -moved(last);
  return added;
}

}  // namespace slam::mono_ekf
