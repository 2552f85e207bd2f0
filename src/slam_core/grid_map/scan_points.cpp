// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_points.hpp"

#include <cmath>
#include <optional>

namespace slam::grid_map {
namespace {

std::optional<ScanPoints::Beam> beamOf(const LaserBeam& beam, const LaserScan& scan,
                                       const BeamModel& model) {
  const double range = beam.range;
  if (!std::isfinite(beam.bearing) || !(range > 0.0)) return std::nullopt;
  const bool is_hit = beam.hit && range <= model.usableRange();
  const double free = beam.hit ? model.usableRange() : std::min(range, model.freeRange());
  const double length = is_hit ? range : free;
  if (!(length > 0.0)) return std::nullopt;
  const Eigen::Vector2d direction(std::cos(double{beam.bearing}), std::sin(double{beam.bearing}));
  const Eigen::Vector2d end = scan.sensor_pose.transform(length * direction);
  const double sigma = scan.relative_sigma * range;
  if (!is_hit) return ScanPoints::Beam{end / model.resolution(), LogOdds{0}, 0.0};
  return ScanPoints::Beam{end / model.resolution(), model.gainOf(sigma),
                          sigma / model.resolution()};
}

}  // namespace

bool ScanPoints::isOnMap(const Pose2& pose) const {
  constexpr double kMostCells = 1 << 28;
  return pose.isFinite() && (cells_per_metre * pose.position()).cwiseAbs().maxCoeff() < kMostCells;
}

ScanPoints pointsOf(const LaserScan& scan, const BeamModel& model, double spacing) {
  ScanPoints points;
  points.cells_per_metre = 1.0 / model.resolution();
  if (!points.isOnMap(scan.sensor_pose)) return points;
  points.origin = scan.sensor_pose.position() / model.resolution();
  points.relative_sigma = scan.relative_sigma;
  points.beams.reserve(scan.beams.size());
  const double apart = spacing / model.resolution();
  for (const auto& read : scan.beams) {
    const auto beam = beamOf(read, scan, model);
    if (!beam) continue;
    points.beams.push_back(*beam);
    if (beam->isHit() && (points.ends.empty() || (beam->end - points.ends.back()).norm() >= apart))
      points.ends.push_back(beam->end);
  }
  return points;
}

}  // namespace slam::grid_map
