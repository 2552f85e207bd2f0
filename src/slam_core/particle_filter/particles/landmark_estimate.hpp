// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace slam::particle_filter {

/// The small Gaussian of one landmark in one particle's map [m, m^2] (Eq. 5.5), in five numbers.
struct LandmarkEstimate {
  double x = 0.0, y = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;  ///< covariance
  /// How often it was seen where it should be, less how often elsewhere: what a wrong reading put
  /// into the map loses it.
  int credit = 0;
  std::uint32_t number = 0;  ///< of the landmark, see LandmarkIndex

  LandmarkEstimate() = default;
  LandmarkEstimate(const Eigen::Vector2d& mean, const Eigen::Matrix2d& P)
      : x(mean.x()), y(mean.y()), xx(P(0, 0)), xy(0.5 * (P(0, 1) + P(1, 0))), yy(P(1, 1)) {}

  static constexpr int kMostCredit = 9;
  /// From here on it rather is the robot that is elsewhere than the landmark.
  static constexpr int kEstablished = 3;
  bool isEstablished() const { return credit >= kEstablished; }

  Eigen::Vector2d mean() const { return {x, y}; }
  Eigen::Matrix2d covariance() const { return (Eigen::Matrix2d() << xx, xy, xy, yy).finished(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(x, y, xx, xy, yy, credit, number);
  }
};

}  // namespace slam::particle_filter
