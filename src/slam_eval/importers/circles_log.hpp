// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slam::eval {

/// The DLR data set of circles on a floor (Kurlbaum, Frese 2009), in REP-103: x forward, y left.
/// The file's own axes are x right and -y forward, which mirrors them, so that headings change
/// sign.
struct CirclesLog {
  /// A circle seen after a step: range [m] and bearing [rad] with the covariance of its Cartesian
  /// position propagated. -1: not identified.
  struct Reading {
    std::int64_t id = -1;
    double range = 0.0, bearing = 0.0;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  };
  /// A displacement (x, y, theta) [m, m, rad] in the robot's frame before it, with its covariance.
  struct Step {
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    std::vector<Reading> readings;
  };

  std::vector<Step> steps;
  std::size_t several_ids = 0;   ///< readings that name more than one circle; the first counts
  std::size_t unidentified = 0;  ///< readings without an id
};

/// @throw ImportError the file cannot be read, holds no step, or a line is not what it must be
CirclesLog readCircles(const std::string& path);

}  // namespace slam::eval
