// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/light_map.hpp"

#include <algorithm>
#include <cmath>

namespace slam::sim {
namespace {

constexpr double kEvenLight = 0.45;      ///< what walls and ceiling throw back
constexpr double kReach = 5.0;           ///< of a lamp, across [m]
constexpr double kPanel = 0.8;           ///< a lamp is no point: softens the light near to it [m]
constexpr double kGrid = 0.2;            ///< [m]
constexpr double kCornerDarkness = 0.2;  ///< less light where floor and wall meet
constexpr double kCornerReach = 0.12;    ///< [m]

/// 1 below the lamp, 0 with zero slope at its reach.
double window(double distance_across) {
  const double part = std::min(distance_across / kReach, 1.0);
  return (1.0 - part * part) * (1.0 - part * part);
}

}  // namespace

double irradiance(const Lamps& lamps, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const auto first = [&](double x) {
    return std::ceil((x - kReach - lamps.first) / lamps.spacing) * lamps.spacing + lamps.first;
  };
  const double below = std::max(lamps.height - point.z(), 0.0);
  double direct = 0.0;
  for (double y = first(point.y()); y <= point.y() + kReach; y += lamps.spacing) {
    for (double x = first(point.x()); x <= point.x() + kReach; x += lamps.spacing) {
      const Eigen::Vector3d to_lamp(x - point.x(), y - point.y(), below);
      const double r = std::sqrt(to_lamp.squaredNorm() + kPanel * kPanel);
      // Walls are seen from both sides, and what faces away still gets the ceiling's light.
      const double facing = 0.5 * (std::abs(normal.dot(to_lamp)) / r + 0.4);
      direct += facing * (below / r) * window(to_lamp.head<2>().norm()) / (r * r);
    }
  }
  const double strength = 0.62 * lamps.height * lamps.height * std::min(lamps.spacing / 2.4, 1.5);
  const double corner = 1.0 - kCornerDarkness * std::exp(-std::abs(point.z()) / kCornerReach) *
                                  (1.0 - std::abs(normal.z()));
  return corner * (kEvenLight + strength * direct);
}

LightMap LightMap::even(double value) {
  LightMap map;
  map.values_.assign(4, static_cast<float>(value));
  return map;
}

LightMap::LightMap(const Rectangle& rectangle, const Lamps& lamps)
    : columns_(std::max(1, static_cast<int>(std::ceil(rectangle.width / kGrid)))),
      rows_(std::max(1, static_cast<int>(std::ceil(rectangle.height / kGrid)))) {
  per_metre_u_ = columns_ / rectangle.width;
  per_metre_v_ = rows_ / rectangle.height;
  for (int row = 0; row <= rows_; ++row) {
    for (int column = 0; column <= columns_; ++column) {
      const auto point = rectangle.at(column / per_metre_u_, row / per_metre_v_);
      values_.push_back(static_cast<float>(irradiance(lamps, point, rectangle.normal())));
    }
  }
}

float LightMap::at(double u, double v) const {
  const double x = std::clamp(u * per_metre_u_, 0.0, static_cast<double>(columns_));
  const double y = std::clamp(v * per_metre_v_, 0.0, static_cast<double>(rows_));
  const int column = std::min(static_cast<int>(x), columns_ - 1);
  const int row = std::min(static_cast<int>(y), rows_ - 1);
  const auto fx = static_cast<float>(x - column), fy = static_cast<float>(y - row);
  const float* upper = &values_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  const float* lower = upper + columns_ + 1;
  const float above = upper[0] + fx * (upper[1] - upper[0]);
  const float below = lower[0] + fx * (lower[1] - lower[0]);
  return above + fy * (below - above);
}

}  // namespace slam::sim
