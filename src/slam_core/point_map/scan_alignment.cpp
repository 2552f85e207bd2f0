// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/scan_alignment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace slam::point_map {
namespace {

constexpr int kIterations = 20;
constexpr std::size_t kEnds = 360;       ///< so many end points tell enough
constexpr double kSigma = 0.03;          ///< of an end point across the surface [m]
constexpr double kIndependent = 60.0;    ///< end points of a scan that count as independent
constexpr double kLineRadius = 0.15;     ///< of the points that a line is drawn through [m]
constexpr std::uint32_t kHeaviest = 10;  ///< more end points of a map point count no more
constexpr double kShrink = 0.7;          ///< of the radius, each iteration
constexpr double kSmallestRadius = 0.1;  ///< [m]
constexpr double kConverged = 1e-4;      ///< [m], [rad]

std::vector<Eigen::Vector2d> endsInBase(const LaserScan& scan) {
  std::vector<Eigen::Vector2d> ends;
  forEachFan(scan, [&](const LaserFan& fan) {
    for (const auto& beam : fan.beams)
      if (beam.hit) ends.push_back(fan.sensor_pose.transform(beam.end()));
  });
  const auto stride = std::max<std::size_t>(1, ends.size() / kEnds);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ends.size(); i += stride) ends[kept++] = ends[i];
  ends.resize(kept);
  return ends;
}

/// Cauchy's: what does not fit counts little.
double weightOf(double residual) { return 1.0 / (kSigma * kSigma + residual * residual); }

Pose2 corrected(const Pose2& pose, const Eigen::Vector3d& delta) {
  return Pose2::fromVector(pose.vector() + delta);
}

}  // namespace

std::optional<Pose2> ScanAlignment::align(const LaserScan& scan, const Pose2& guess,
                                          const Pose2& prior, const PointSet& map) {
  ends_ = endsInBase(scan);
  lines_.clear();
  if (ends_.empty()) return std::nullopt;
  Pose2 pose = guess;
  double radius = config_.alignment_distance;
  for (int i = 0; i < kIterations; ++i) {
    auto sums = compare(pose, radius, map);
    if (static_cast<double>(sums.matched) <
        config_.alignment_share * static_cast<double>(ends_.size()))
      return std::nullopt;
    addPrior(pose, prior, sums);
    const Eigen::Vector3d delta = sums.H.ldlt().solve(sums.b);
    if (!delta.allFinite()) return std::nullopt;
    pose = corrected(pose, delta);
    if (radius <= kSmallestRadius && delta.cwiseAbs().maxCoeff() < kConverged) break;
    radius = std::max(std::min(kSmallestRadius, radius), radius * kShrink);
  }
  return pose;
}

ScanAlignment::NormalEquations ScanAlignment::compare(const Pose2& T_map_base, double radius,
                                                      const PointSet& map) {
  NormalEquations sums;
  for (const auto& end : ends_) {
    const Eigen::Vector2d at = T_map_base.transform(end);
    const auto point = map.nearest(at, radius);
    if (!point) continue;
    ++sums.matched;
    const auto& line = lineAt(*point, map);
    if (!line.is_line) continue;
    const double residual = line.normal.dot(line.point - at);
    const Eigen::Vector2d arm = at - T_map_base.position();
    const Eigen::Vector3d J(line.normal.x(), line.normal.y(),
                            line.normal.y() * arm.x() - line.normal.x() * arm.y());
    const double weight = weightOf(residual);
    sums.H += weight * J * J.transpose();
    sums.b += weight * residual * J;
  }
  // neighbouring beams share their errors, and the map's points are no truth
  const double share =
      std::min(1.0, kIndependent / static_cast<double>(std::max<std::size_t>(1, sums.matched)));
  sums.H *= share;
  sums.b *= share;
  return sums;
}

void ScanAlignment::addPrior(const Pose2& T_map_base, const Pose2& prior,
                             NormalEquations& sums) const {
  const double p = config_.prior_sigma_position, h = config_.prior_sigma_heading;
  const Eigen::Vector3d information(1 / (p * p), 1 / (p * p), 1 / (h * h));
  Eigen::Vector3d error = prior.vector() - T_map_base.vector();
  error.z() = std::remainder(error.z(), 2 * M_PI);
  sums.H.diagonal() += information;
  sums.b += information.cwiseProduct(error);
}

const SurfaceLine& ScanAlignment::lineAt(std::uint32_t point, const PointSet& map) {
  const auto [entry, is_new] = lines_.try_emplace(point);
  if (is_new)
    entry->second = surfaceLine(map.points()[point].position, kLineRadius, kHeaviest, map);
  return entry->second;
}

}  // namespace slam::point_map
