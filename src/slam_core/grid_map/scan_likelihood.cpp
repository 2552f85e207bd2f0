// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_likelihood.hpp"

#include <Eigen/LU>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam::grid_map {
namespace {

/// The likelihood of a cell; 0 where there is none.
int likelihoodOf(const GridMap& map, CellIndex cell) {
  const auto* const tile = map.tile(cell);
  return tile == nullptr ? 0 : tile->likelihood[Tile::at(cell)];
}

/// Between the middles of four cells [0, 255].
float interpolated(const GridMap& map, double x, double y) {
  constexpr double kPositive = 1 << 30;
  const double u = x - 0.5, v = y - 0.5;
  const CellIndex cell{static_cast<std::int32_t>(u + kPositive) - (1 << 30),
                       static_cast<std::int32_t>(v + kPositive) - (1 << 30)};
  const auto a = static_cast<float>(u - cell.x), b = static_cast<float>(v - cell.y);
  float f00, f10, f01, f11;
  constexpr std::int32_t kLast = Tile::kSize - 1;
  if ((cell.x & kLast) != kLast && (cell.y & kLast) != kLast) {
    const auto* const tile = map.tile(cell);
    if (tile == nullptr) return 0.0f;
    const auto* const at = &tile->likelihood[Tile::at(cell)];
    f00 = at[0];
    f10 = at[1];
    f01 = at[Tile::kSize];
    f11 = at[Tile::kSize + 1];
  } else {
    f00 = static_cast<float>(likelihoodOf(map, cell));
    f10 = static_cast<float>(likelihoodOf(map, {cell.x + 1, cell.y}));
    f01 = static_cast<float>(likelihoodOf(map, {cell.x, cell.y + 1}));
    f11 = static_cast<float>(likelihoodOf(map, {cell.x + 1, cell.y + 1}));
  }
  const float low = f00 + a * (f10 - f00), high = f01 + a * (f11 - f01);
  return low + b * (high - low);
}

}  // namespace

ScanLikelihood::ScanLikelihood(double outlier, double weight) {
  for (std::size_t i = 0; i < logs_.size(); ++i)
    logs_[i] = static_cast<float>(
        weight * std::log((static_cast<double>(i) / 255.0 + outlier) / (1.0 + outlier)));
}

double ScanLikelihood::log(const GridMap& map, const ScanPoints& scan, const Pose2& pose) const {
  if (!scan.isOnMap(pose)) return logs_[0] * static_cast<double>(scan.ends.size());
  const double c = std::cos(pose.theta()), s = std::sin(pose.theta());
  const Eigen::Vector2d at = scan.cells_per_metre * pose.position();
  double sum = 0.0;
  for (const auto& end : scan.ends) {
    const float f =
        interpolated(map, c * end.x() - s * end.y() + at.x(), s * end.x() + c * end.y() + at.y());
    sum += logs_[static_cast<std::size_t>(f + 0.5f)];
  }
  return sum;
}

MatchObjective::MatchObjective(const ScanLikelihood& likelihood, const GridMap& map,
                               const ScanPoints& scan, const Pose2& prior,
                               const Eigen::Matrix3d& covariance)
    : likelihood_(likelihood),
      map_(map),
      scan_(scan),
      prior_(prior),
      information_(covariance.inverse()),
      sigma_(covariance.diagonal().cwiseSqrt()) {}

double MatchObjective::logPrior(const Pose2& pose) const {
  const Eigen::Vector3d error(pose.x() - prior_.x(), pose.y() - prior_.y(),
                              wrapAngle(pose.theta() - prior_.theta()));
  return -0.5 * error.dot(information_ * error);
}

}  // namespace slam::grid_map
