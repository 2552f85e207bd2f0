// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/surface_line.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace slam::point_map {
namespace {

constexpr std::size_t kPoints = 4;  ///< fewer make no line
constexpr double kFlatness = 0.1;   ///< thickness over length, both squared, of a line

}  // namespace

SurfaceLine surfaceLine(const Eigen::Vector2d& place, double radius, std::uint32_t cap,
                        const PointSet& map) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double weights = 0.0;
  std::size_t count = 0;
  map.visitNear(place, radius, [&](std::uint32_t near) {
    const Eigen::Vector2d offset = map.points()[near].position - place;
    const double weight = std::min(map.points()[near].count, cap);
    sum += weight * offset;
    squares += weight * offset * offset.transpose();
    weights += weight;
    ++count;
  });
  SurfaceLine line;
  if (count < kPoints) return line;
  const Eigen::Vector2d mean = sum / weights;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(squares / weights - mean * mean.transpose());
  line.point = place + mean;
  line.normal = axes.eigenvectors().col(0);
  line.is_line = axes.eigenvalues()(0) < kFlatness * axes.eigenvalues()(1);
  return line;
}

}  // namespace slam::point_map
